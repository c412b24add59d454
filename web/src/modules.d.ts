// What the build provides: see build.mjs.

declare module "core" {
  export default function createCore(options?: object): Promise<unknown>;
}

/// The text of the script of the worker.
declare module "worker-text" {
  const text: string;
  export default text;
}
