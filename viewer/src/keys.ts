/** The keyboard. */

export type Actions = Record<string, (event: KeyboardEvent) => void>;

/** The keys that move a slider. */
const SLIDES = /^(Arrow|Home|End|Page)/;

/** Returns true if the focused element takes the key itself: a field for text all keys, a slider the keys that move it,
 * a checkbox, a button or a summary the keys that press it. Along the slider of time, ← and → are keys of the page,
 * which are finer. */
export function takes(target: { tagName: string; type?: string; id?: string }, key: string): boolean {
  const { tagName, type, id } = target;
  if (tagName === "SELECT" || tagName === "TEXTAREA") return true;
  if (tagName === "INPUT") {
    if (type === "range") return SLIDES.test(key) && !(id === "slider" && /^Arrow(Left|Right)$/.test(key));
    return type !== "checkbox" || key === " ";
  }
  return (tagName === "BUTTON" || tagName === "SUMMARY") && (key === " " || key === "Enter");
}

/** Calls the action of each key that is pressed, unless the focused element takes it. */
export function listen(actions: Actions): void {
  document.addEventListener("keydown", (event) => {
    const { target } = event;
    if (target instanceof HTMLElement && takes(target, event.key)) return;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const action = actions[event.key];
    if (action === undefined || document.querySelector("dialog[open]") !== null) return;
    event.preventDefault();
    action(event);
  });
}
