// Decoder of the file format .lzma. Source: I. Pavlov, LZMA specification, 2015 (public domain).

/** Probabilities have 11 bits and are adapted by 1/32 of their error; the range is filled up below 2²⁴. */
const PROBABILITY_BITS = 11;
const HALF = 1 << (PROBABILITY_BITS - 1);
const ADAPTATION = 5;
const LEAST_RANGE = 2 ** 24;
/** Properties (1 byte), size of the dictionary (4), size of the content (8; all bits set: up to the end mark). */
const HEADER = 13;
/** State of the decoder after a literal, a match, a repeated match and a repeated byte; from 7, the last part was no literal. */
const STATES = 12;
const FIRST_AFTER_MATCH = 7;
const LEAST_LENGTH = 2;
const DISTANCE_SLOTS = 64;
const ALIGN_BITS = 4;
/** Distances below this have their own probabilities for all bits, those from it on for the highest and the lowest bits. */
const FIRST_WIDE_SLOT = 14;

const probabilities = (count: number) => new Uint16Array(count).fill(HALF);

/** Content of a compressed file. Throws an error for data that are damaged or end early. */
export function decodeLzma(packed: Uint8Array): Uint8Array<ArrayBuffer> {
  const properties = packed[0];
  const lc = properties % 9;
  const lp = Math.floor(properties / 9) % 5;
  const pb = Math.floor(properties / 45);
  if (packed.length < HEADER + 5 || pb > 4) throw new Error('the engine is damaged: no LZMA data');
  let size = 0;
  for (let i = 7; i >= 0; i--) size = size * 256 + packed[5 + i];
  // All bits set: not a size.
  const hasSize = size < 2 ** 53;
  let out = new Uint8Array(hasSize ? size : 4 * packed.length);
  let written = 0;

  const isMatch = probabilities(STATES << 4);
  const isRepeat = probabilities(STATES);
  const isRepeat0 = probabilities(STATES);
  const isRepeat1 = probabilities(STATES);
  const isRepeat2 = probabilities(STATES);
  const isRepeat0Long = probabilities(STATES << 4);
  const literals = probabilities(0x300 << (lc + lp));
  const slots = probabilities(4 * DISTANCE_SLOTS);
  const special = probabilities(128);
  const align = probabilities(1 << ALIGN_BITS);
  // Lengths: two choices, 16 trees of 3 bits for short ones, 16 for middle ones, one of 8 bits for long ones.
  const LOW = 2, MIDDLE = LOW + (16 << 3), HIGH = MIDDLE + (16 << 3);
  const lengths = probabilities(HIGH + 256);
  const repeatLengths = probabilities(HIGH + 256);

  let at = HEADER + 1;
  // Range and code, unsigned. In variables, engines of JavaScript would allocate a number for each step.
  const coder = new Uint32Array([0xffffffff, 0]);
  for (let i = 0; i < 4; i++) coder[1] = (coder[1] << 8) | packed[at++];

  const shift = () => {
    coder[0] <<= 8;
    coder[1] = (coder[1] << 8) | packed[at++];
  };
  const bit = (table: Uint16Array, index: number): number => {
    const p = table[index];
    const range = coder[0];
    const code = coder[1];
    const bound = Math.imul(range >>> PROBABILITY_BITS, p) >>> 0;
    if (code < bound) {
      table[index] = p + (((1 << PROBABILITY_BITS) - p) >> ADAPTATION);
      coder[0] = bound;
      if (bound < LEAST_RANGE) shift();
      return 0;
    }
    table[index] = p - (p >> ADAPTATION);
    coder[0] = range - bound;
    coder[1] = code - bound;
    if (coder[0] < LEAST_RANGE) shift();
    return 1;
  };
  const tree = (table: Uint16Array, from: number, bits: number): number => {
    let node = 1;
    for (let i = 0; i < bits; i++) node = 2 * node + bit(table, from + node);
    return node - (1 << bits);
  };
  const reversedTree = (table: Uint16Array, from: number, bits: number): number => {
    let [node, value] = [1, 0];
    for (let i = 0; i < bits; i++) {
      const b = bit(table, from + node);
      node = 2 * node + b;
      value |= b << i;
    }
    return value;
  };
  const direct = (bits: number): number => {
    let value = 0;
    for (let i = 0; i < bits; i++) {
      coder[0] >>>= 1;
      const b = coder[1] >= coder[0] ? 1 : 0;
      if (b) coder[1] -= coder[0];
      if (coder[0] < LEAST_RANGE) shift();
      value = 2 * value + b;
    }
    return value;
  };
  const lengthOf = (table: Uint16Array, position: number): number => {
    if (!bit(table, 0)) return tree(table, LOW + (position << 3), 3);
    if (!bit(table, 1)) return 8 + tree(table, MIDDLE + (position << 3), 3);
    return 16 + tree(table, HIGH, 8);
  };
  const distanceOf = (length: number): number => {
    const slot = tree(slots, Math.min(length, 3) * DISTANCE_SLOTS, 6);
    if (slot < 4) return slot;
    const bits = (slot >> 1) - 1;
    const distance = (2 | (slot & 1)) * 2 ** bits;
    if (slot < FIRST_WIDE_SLOT) return distance + reversedTree(special, distance - slot, bits);
    return distance + direct(bits - ALIGN_BITS) * (1 << ALIGN_BITS) + reversedTree(align, 0, ALIGN_BITS);
  };
  const reserve = (count: number) => {
    if (written + count <= out.length) return;
    if (hasSize) throw new Error('the engine is damaged: more data than its stated size');
    const larger = new Uint8Array(2 * out.length + count);
    larger.set(out);
    out = larger;
  };

  let state = 0;
  let [rep0, rep1, rep2, rep3] = [0, 0, 0, 0];
  for (;;) {
    if (hasSize && written === size) return out;
    if (at > packed.length) throw new Error('the engine is damaged: its data end early');
    const position = written & ((1 << pb) - 1);
    if (!bit(isMatch, (state << 4) + position)) {
      reserve(1);
      const before = written ? out[written - 1] : 0;
      const from = 0x300 * (((written & ((1 << lp) - 1)) << lc) + (before >> (8 - lc)));
      let symbol = 1;
      if (state >= FIRST_AFTER_MATCH) {
        // The byte at the distance of the last match differs from this one.
        let other = out[written - rep0 - 1];
        do {
          const expected = (other >> 7) & 1;
          other <<= 1;
          const b = bit(literals, from + ((1 + expected) << 8) + symbol);
          symbol = 2 * symbol + b;
          if (expected !== b) break;
        } while (symbol < 0x100);
      }
      while (symbol < 0x100) symbol = 2 * symbol + bit(literals, from + symbol);
      out[written++] = symbol;
      state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
      continue;
    }
    let length;
    if (bit(isRepeat, state)) {
      if (!bit(isRepeat0, state)) {
        if (!bit(isRepeat0Long, (state << 4) + position)) {
          reserve(1);
          state = state < FIRST_AFTER_MATCH ? 9 : 11;
          out[written] = out[written - rep0 - 1];
          written++;
          continue;
        }
      } else {
        let distance;
        if (!bit(isRepeat1, state)) {
          distance = rep1;
        } else {
          if (!bit(isRepeat2, state)) {
            distance = rep2;
          } else {
            distance = rep3;
            rep3 = rep2;
          }
          rep2 = rep1;
        }
        rep1 = rep0;
        rep0 = distance;
      }
      length = lengthOf(repeatLengths, position);
      state = state < FIRST_AFTER_MATCH ? 8 : 11;
    } else {
      [rep3, rep2, rep1] = [rep2, rep1, rep0];
      length = lengthOf(lengths, position);
      state = state < FIRST_AFTER_MATCH ? 7 : 10;
      rep0 = distanceOf(length);
      // The end mark.
      if (rep0 === 0xffffffff) {
        if (hasSize) throw new Error('the engine is damaged: less data than its stated size');
        return out.slice(0, written);
      }
    }
    if (rep0 >= written) throw new Error('the engine is damaged: a distance before the first byte');
    length += LEAST_LENGTH;
    reserve(length);
    for (let from = written - rep0 - 1; length > 0; length--) out[written++] = out[from++];
  }
}
