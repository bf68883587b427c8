/** Some slots of the store, in order: `slots[0]` to `slots[count - 1]`. */
export interface SlotList {
  readonly slots: Int32Array;
  readonly count: number;
}
