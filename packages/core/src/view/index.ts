/** What every renderer needs and no physics does. */
export { Bindings } from './bindings.ts';
export type { Bounds } from './bounds.ts';
export { Camera, type CameraOptions } from './camera.ts';
export type { Color, Ramp } from './color-style.ts';
export { DrawList } from './draw-list.ts';
export { interpolate } from './interpolate.ts';
export type { BungeeStyle, LinkStyle, PinStyle, SpringQuantity, SpringStyle } from './link-style.ts';
export { type Paint, type TrailPaint, trailLevels } from './paint.ts';
export { defaultParticleStyle, Palette } from './palette.ts';
export { PathList, type PathPaint, pathKinds } from './path-list.ts';
export { pickParticle } from './pick.ts';
export type { Renderer } from './renderer.ts';
export type { ArrowStyle, BodyStyle, ContactStyle, LiquidStyle, ShapeStyle } from './scenery-style.ts';
export { Sketch } from './sketch.ts';
export type { ParticleStyle, SpeedRamp, Style, TrailStyle } from './style.ts';
export { Trails } from './trails.ts';
export type { ViewedWorld } from './viewed-world.ts';
