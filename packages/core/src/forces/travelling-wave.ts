import { requireFinite, requireNonNegative, requireOptions, requirePositive } from '../math/checks.ts';
import { sineOfTurns } from '../math/sine.ts';
import type { LiquidLevel } from './buoyancy.ts';

/** What a wave is made of. */
export interface TravellingWaveOptions {
  /** Height of the still liquid. Unit: m. @default 0 */
  level?: number;
  /** Height of a crest above the still liquid, 0 or more. Unit: m. */
  amplitude: number;
  /** Distance from crest to crest, positive. Unit: m. */
  length: number;
  /** Speed to the right; negative runs to the left. Unit: m/s. @default that of deep water, √(g·length / 2π) */
  speed?: number;
}

/**
 * A level that waves: y = level + amplitude·sin(2π·(x - speed·time) / length), from exactly specified arithmetic, so that
 * every engine gives the same bits. Hand it to `Buoyancy`; a sum of several is a sea.
 */
export function travellingWave(options: TravellingWaveOptions): LiquidLevel {
  requireOptions('travellingWave', 'options', options, '{ amplitude: 0.2, length: 4 }');
  const { level = 0, amplitude, length } = options;
  requireFinite('travellingWave', 'level', level, 'metres');
  requireNonNegative('travellingWave', 'amplitude', amplitude, 'metres');
  requirePositive('travellingWave', 'length', length, 'metres');
  const { speed = Math.sqrt((9.81 * length) / (2 * Math.PI)) } = options;
  requireFinite('travellingWave', 'speed', speed, 'metres per second');
  return (x, time) => level + amplitude * sineOfTurns((x - speed * time) / length);
}
