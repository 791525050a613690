/** Playing: time passes while the state says so. */

import { momentAt } from "./frames";
import { type Store } from "./state";

/** The duration of a single step, and of a step of a longer motion, in seconds. */
const [STEP, FRAME] = [4, 0.25];

/** The longest time that passes from one picture to the next, in milliseconds, however long the pictures take. */
const LONGEST = 100;

export function play(store: Store, frameCount: () => number): void {
  let last: number | null = null;
  const tick = (now: number): void => {
    if (!store.state.playing) {
      last = null;
      return;
    }
    const steps = frameCount() - 1;
    const duration = steps === 1 ? STEP : FRAME;
    const { frame, t } = store.state.moment;
    const passed = Math.min(now - (last ?? now), LONGEST) / 1000;
    const position = frame + t + passed / duration;
    last = now;
    store.set({ moment: momentAt(position, frameCount()), playing: position < steps });
    requestAnimationFrame(tick);
  };
  store.observe(({ playing, moment }, change) => {
    const steps = frameCount() - 1;
    if (change.playing === true && steps < 1) store.set({ playing: false });
    if (change.playing !== true || last !== null || steps < 1) return;
    last = performance.now();
    if (playing && moment.frame + moment.t >= steps) store.set({ moment: { frame: 0, t: 0 } });
    requestAnimationFrame(tick);
  });
}
