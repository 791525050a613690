/** The page that contains its data. */

import { block } from "./elements";
import { read } from "./source";
import { fail, Viewer } from "./viewer";

async function open(): Promise<void> {
  const viewer = new Viewer();
  await viewer.open(await read(block));
}

open().catch(fail);
