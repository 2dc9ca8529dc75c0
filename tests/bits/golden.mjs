// Runs golden.wasm as the program `golden` runs elsewhere: node golden.mjs golden.wasm
import { readFileSync } from "node:fs";

const module = new WebAssembly.Module(readFileSync(process.argv[2]));
const imports = WebAssembly.Module.imports(module);
if (imports.length > 0) throw new Error(`imports: ${imports.map((i) => i.name).join(" ")}`);

const { memory, report, _initialize } = new WebAssembly.Instance(module).exports;
_initialize();
for (let section = 0, at; (at = report(section)) !== 0; ++section) {
  const bytes = new Uint8Array(memory.buffer, at);
  console.log(new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0))));
}
