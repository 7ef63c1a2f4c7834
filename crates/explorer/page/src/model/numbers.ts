// Numbers as text; the number of digits follows from the stated error.

const MOST_DIGITS = 5;

/** Rounded to significant digits, without an exponent for ordinary sizes. */
export function digits(x: number, count = MOST_DIGITS): string {
  if (x === 0) return '0';
  const exponent = Math.floor(Math.log10(Math.abs(x)));
  if (exponent < -4 || exponent > 6) return superscript(x.toExponential(Math.max(0, count - 1)));
  return x.toFixed(Math.min(12, Math.max(0, count - 1 - exponent)));
}

/** Mass with as many digits as its error bound leaves, at most `most`. */
export function mass(m: number, error: number | null, most = MOST_DIGITS): string {
  const known = error && error > 0 ? Math.floor(Math.log10(Math.abs(m) / error)) : most;
  return digits(m, Math.min(most, Math.max(1, known)));
}

/** Name of a model as words. */
export const words = (name: string) => name.replaceAll('_', ' ');

/** Error bound with one digit: 2·10⁻¹¹. */
export function bound(x: number): string {
  return superscript(x.toExponential(0));
}

function superscript(text: string): string {
  const [number, power] = text.split('e');
  if (!power) return text;
  const raised = String(Number(power)).replace(/./g, (c) => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(c)]));
  return `${number}·10${raised}`;
}

/** Fixed decimals without a negative zero; the minus sign is that of print. */
export function fixed(x: number, decimals: number): string {
  const text = x.toFixed(decimals);
  return (Number(text) === 0 ? text.replace('-', '') : text).replace('-', '−');
}

/** Fixed decimals with the sign. */
export function signed(x: number, decimals: number): string {
  const text = fixed(x, decimals);
  return text.startsWith('−') || Number(text) === 0 ? text : `+${text}`;
}

/** Shortest number for commands: no more than twelve digits, no trailing zeros. */
export function plain(x: number): string {
  return String(Number(x.toPrecision(12)) + 0);
}

export interface DisplayUnit { name: string; perSi: number; decimals: number; step: number }
export const MILLIMETRE: DisplayUnit = { name: 'mm', perSi: 1000, decimals: 1, step: 0.5 };
export const DEGREE: DisplayUnit = { name: '°', perSi: 180 / Math.PI, decimals: 1, step: 0.5 };

/** SI value of a position in text: 30deg, 5mm, 0.2. */
export function siValue(text: string): number {
  const match = /^\s*([-+0-9.eE]+)\s*(mm|cm|m|deg|rad)?\s*$/.exec(text);
  if (!match) return NaN;
  const scale: Record<string, number> = { mm: 1e-3, cm: 1e-2, m: 1, deg: Math.PI / 180, rad: 1 };
  return Number(match[1]) * (match[2] ? scale[match[2]] : 1);
}

/** Ticks of an axis: round numbers, at least two. */
export function ticks(from: number, to: number, most: number): number[] {
  const raw = (to - from) / Math.max(1, most);
  if (!(raw > 0) || !Number.isFinite(raw)) return [from];
  const power = 10 ** Math.floor(Math.log10(raw));
  const count = (step: number) => Math.floor(to / step + 1e-9) - Math.ceil(from / step - 1e-9) + 1;
  const steps = [0.5, 1, 2, 5, 10].map((k) => k * power);
  const wide = steps.findIndex((s) => s >= raw * 0.999);
  const step = steps.slice(0, wide + 1).findLast((s) => count(s) >= 2) ?? steps[0];
  const out: number[] = [];
  for (let k = Math.ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; k++) out.push(Number((k * step).toPrecision(12)));
  return out;
}
