/** The keyboard. */

export type Actions = Record<string, (event: KeyboardEvent) => void>;

/** Calls the action of each key that is pressed, except in a field that takes keys itself. */
export function listen(actions: Actions): void {
  document.addEventListener("keydown", (event) => {
    const { target } = event;
    const isText = target instanceof HTMLSelectElement || (target instanceof HTMLInputElement && /^(search|text|file)$/.test(target.type));
    const isButton = target instanceof HTMLButtonElement && (event.key === " " || event.key === "Enter");
    if (isText || isButton || event.ctrlKey || event.metaKey || event.altKey) return;
    const action = actions[event.key];
    if (action === undefined || document.querySelector("dialog[open]") !== null) return;
    event.preventDefault();
    action(event);
  });
}
