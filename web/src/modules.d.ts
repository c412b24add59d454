// What the build provides: see build.mjs.

declare module "core" {
  import type { Answer, Settings } from "./worker";
  interface Core {
    version: string;
    mapFile(
      name: string,
      bytes: Uint8Array,
      settings: Settings,
      hear: (what: string, payload: unknown) => boolean,
    ): Answer;
    segmentLast(): Int32Array | undefined;
  }
  export default function createCore(): Promise<Core>;
}

/// The text of the script of the worker.
declare module "worker-text" {
  const text: string;
  export default text;
}
