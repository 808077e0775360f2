#!/usr/bin/env node
// npx mien-face [--port N] [--host ADDRESS]: serves pictures by address, until Ctrl-C (server.js).
import { listen } from './server.js';

const options = { '--port': '6437', '--host': '127.0.0.1' }, given = process.argv.slice(2);
for (let i = 0; i < given.length; i += 2) {
  if (!(given[i] in options) || given[i + 1] === undefined) console.error(`${given[i]}: usage: mien-face [--port N] [--host ADDRESS]`), process.exit(2);
  options[given[i]] = given[i + 1];
}
try {
  const { address, port } = (await listen(Number(options['--port']), options['--host'])).address();
  console.log(`http://${address.includes(':') ? `[${address}]` : address}:${port}/svg?seed=ada`);
} catch (error) { console.error(`cannot serve: ${error.message}`), process.exit(1); }
