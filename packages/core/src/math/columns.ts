/**
 * Gives every typed array that an object has as a field room for `capacity` numbers; what stands in it is kept. So a column
 * more is one field more, and none is forgotten when its table grows.
 */
export function growColumns(table: object, capacity: number): void {
  const fields = table as Record<string, Float64Array>;
  for (const [name, column] of Object.entries(fields)) {
    if (!ArrayBuffer.isView(column)) continue;
    fields[name] = new (column.constructor as Float64ArrayConstructor)(capacity);
    fields[name].set(column);
  }
}
