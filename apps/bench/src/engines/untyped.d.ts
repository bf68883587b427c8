// What is used here of packages that come without types.

interface B2Body {
  readonly index1: number;
}

interface B2Vector {
  x: number;
  y: number;
}

declare module 'phaser-box2d/dist/PhaserBox2D.js' {
  interface WorldDef {
    gravity: B2Vector;
    enableSleep: boolean;
  }
  interface ShapeDef {
    friction: number;
    restitution: number;
    density: number;
  }
  interface BodyDef {
    type: number;
    position: B2Vector;
    linearVelocity: B2Vector;
    linearDamping: number;
    isBullet: boolean;
  }
  interface JointDef {
    bodyIdA: B2Body;
    bodyIdB: B2Body;
    length: number;
  }
  interface MassData {
    mass: number;
    center: B2Vector;
    rotationalInertia: number;
  }
  interface World {
    readonly index1: number;
  }
  export const b2BodyType: { readonly b2_dynamicBody: number };
  export const b2Vec2: new (x: number, y: number) => B2Vector;
  export const b2Circle: new (centre: B2Vector, radius: number) => object;
  export function b2CreateWorldArray(): void;
  export function b2DefaultWorldDef(): WorldDef;
  export function b2CreateWorld(def: WorldDef): World;
  export function b2DefaultShapeDef(): ShapeDef;
  export function b2DefaultBodyDef(): BodyDef;
  export function b2CreateBody(world: World, def: BodyDef): B2Body;
  export function b2MakeBox(halfWidth: number, halfHeight: number): object;
  export function b2CreatePolygonShape(body: B2Body, def: ShapeDef, polygon: object): void;
  export function b2CreateCircleShape(body: B2Body, def: ShapeDef, circle: object): void;
  export function b2DefaultDistanceJointDef(): JointDef;
  export function b2CreateDistanceJoint(world: World, def: JointDef): void;
  export function b2World_Step(world: World, dt: number, subSteps: number): void;
  export function b2Body_GetPosition(body: B2Body): B2Vector;
  export function b2Body_GetLinearVelocity(body: B2Body): B2Vector;
  export function b2Body_GetRotation(body: B2Body): { c: number; s: number };
  export function b2Body_SetMassData(body: B2Body, data: MassData): void;
  export function b2Body_ApplyForceToCenter(body: B2Body, force: B2Vector, wake: boolean): void;
}

declare module '@newkrok/nape-js' {
  export default function initNape(): void;
}
