/** The value below which the given share of all values lies. */
export function quantile(values: ArrayLike<number>, share: number): number {
  const sorted = Float64Array.from(values).sort();
  return sorted.length === 0 ? Number.NaN : sorted[Math.round(share * (sorted.length - 1))];
}

export function median(values: ArrayLike<number>): number {
  return quantile(values, 0.5);
}

/** The mean without the greatest twentieth, in which a busy machine shows. */
export function trimmedMean(values: ArrayLike<number>): number {
  const sorted = Float64Array.from(values).sort();
  return mean(sorted.subarray(0, Math.ceil(0.95 * sorted.length)));
}

export function mean(values: ArrayLike<number>): number {
  return Array.from(values).reduce((sum, value) => sum + value, 0) / values.length;
}
