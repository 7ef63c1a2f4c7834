// Variants that the user keeps for comparison.

import type { Curve, KinematicsReport, Scene, Study } from '../engine/protocol';

/** `colour`: index in the colours of the variants. */
export interface Variant {
  name: string; colour: number; study: Study; mass: number | null; curve: Curve | null; driver: string; scene: Scene; frames: number[];
  kinematics?: KinematicsReport;
}

export const MOST_VARIANTS = 8;

/** First letter that is no name of a variant. */
export const nextName = (variants: Variant[]) => [...'ABCDEFGH'].find((letter) => !variants.some((v) => v.name === letter)) ?? 'A';

/** First colour that no variant has. */
export function nextColour(variants: Variant[]): number {
  return Array.from({ length: MOST_VARIANTS }, (_, i) => i).find((i) => !variants.some((v) => v.colour === i)) ?? 0;
}

/** Key of everything that the results at the named contacts depend on: the design with its conditions and joints, without the travel. */
export function designKey({ model, pose: { travel, ...pose }, conditions, hold }: Study): string {
  void travel;
  return JSON.stringify([model, pose, conditions, hold]);
}
