/** The elements of the page by their ids. */

export function byId<E extends HTMLElement>(id: string, type: new () => E): E {
  const element = document.getElementById(id);
  if (!(element instanceof type)) throw new Error(`the page has no element ${id} of the expected kind`);
  return element;
}

/** The text of a block of data. */
export function block(id: string): string {
  return document.getElementById(id)?.textContent ?? "";
}
