// What mien.wasm asks of its host beside WASI: named here, so that the linker still tells what is missing. mien.js answers.
mergeInto(LibraryManager.library, { mien_asks_to_go_on: (done) => 1 });
