// @ts-check
// Lengths as people read them, and bars of round lengths.

const kPrefixes = /** @type {const} */ ([[1e3, 'km'], [1, 'm'], [1e-3, 'mm'], [1e-6, 'µm'], [1e-9, 'nm']]);

/** @param {number} value @param {number} digits @returns {string} */
export function number(value, digits = 4) {
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (!Number.isFinite(value)) return String(value);
  if (size >= 1e5 || size < 1e-4) return value.toExponential(Math.max(0, digits - 1)).replace(/\.?0+e/, 'e');
  return String(Number(value.toPrecision(digits)));
}

/**
 * Of metres with the prefix that leaves no more than three digits before the point; of other units as it is.
 * @param {number} value @param {string} unit @param {number} digits
 */
export function length(value, unit, digits = 4) {
  if (unit !== 'm' || value === 0 || !Number.isFinite(value)) return `${number(value, digits)} ${unit}`.trim();
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-10) return `${number(value, digits)} m`;
  const [factor, name] = kPrefixes.find(([least]) => size >= least) ?? kPrefixes[kPrefixes.length - 1];
  return `${number(value / factor, digits)} ${name}`;
}

/**
 * The largest of 1, 2 and 5 times a power of ten that is no longer.
 * @param {number} most
 */
export function roundLength(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  for (const factor of [10, 5, 2]) if (factor * power <= most) return factor * power;
  return power;
}

/** The 64 bits of a double, as C writes them with %a. @param {number} value */
export function hexFloat(value) {
  if (!Number.isFinite(value)) return String(value);
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, value);
  const bits = view.getBigUint64(0);
  const sign = bits >> 63n ? '-' : '';
  const exponent = Number(bits >> 52n & 0x7ffn), fraction = bits & 0xfffffffffffffn;
  const digits = fraction.toString(16).padStart(13, '0').replace(/0+$/, '');
  if (exponent === 0 && fraction === 0n) return `${sign}0x0p+0`;
  const power = exponent === 0 ? -1022 : exponent - 1023;
  return `${sign}0x${exponent === 0 ? 0 : 1}${digits ? `.${digits}` : ''}p${power < 0 ? '' : '+'}${power}`;
}
