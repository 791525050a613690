/** The kernel, which runs in a worker. */

import { fromBase64, inflate } from "../binary";
import { type Arguments, type Name, type Request, type Response, type Result } from "./protocol";

interface Waiting {
  resolve: (result: unknown) => void;
  reject: (error: Error) => void;
}

export class Kernel {
  private readonly worker: Worker;
  private readonly waiting = new Map<number, Waiting>();
  private calls = 0;

  /** `program` is the text of the worker. */
  constructor(program: string) {
    const url = URL.createObjectURL(new Blob([program], { type: "text/javascript" }));
    this.worker = new Worker(url);
    this.worker.addEventListener("message", ({ data }: MessageEvent<Response>) => {
      const waiting = this.waiting.get(data.id);
      this.waiting.delete(data.id);
      if ("error" in data) waiting?.reject(new Error(data.error));
      else waiting?.resolve(data.result);
    });
    this.worker.addEventListener("error", ({ message }) => {
      for (const { reject } of this.waiting.values()) reject(new Error(`the kernel has stopped: ${message}`));
      this.waiting.clear();
    });
  }

  /** Compiles the module, which is deflated and in base64. */
  async start(module: string): Promise<void> {
    const bytes = await inflate(fromBase64(module));
    await this.call("start", bytes.buffer as ArrayBuffer);
  }

  /** Calls a function of the kernel. Calls are answered in their order. */
  call<N extends Name>(name: N, ...values: Arguments<N>): Promise<Result<N>> {
    const id = this.calls++;
    return new Promise<unknown>((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      const request: Request = { id, name, arguments: values };
      this.worker.postMessage(request);
    }) as Promise<Result<N>>;
  }
}

/** Runs the latest task at a time: tasks that come while one runs replace each other. */
export class Latest {
  private running = false;
  private next: (() => Promise<void>) | null = null;

  run(task: () => Promise<void>): void {
    this.next = task;
    if (!this.running) void this.work();
  }

  private async work(): Promise<void> {
    this.running = true;
    while (this.next !== null) {
      const task = this.next;
      this.next = null;
      await task();
    }
    this.running = false;
  }
}
