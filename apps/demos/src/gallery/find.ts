/** The element that the page must have; an error says which is missing. */
export function find(selector: string): HTMLElement {
  const element = document.querySelector<HTMLElement>(selector);
  if (!element) throw new Error(`find: the page must have ${selector}; it has none.`);
  return element;
}
