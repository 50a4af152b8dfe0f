/** The types, checked with everything on and no library skipped, by this year's TypeScript and the last one written in JavaScript. */

export async function* check({ run }) {
  for (const compiler of ['typescript', 'typescript5']) {
    const tsc = `node_modules/${compiler}/bin/tsc`;
    const version = (await run(process.execPath, tsc, '--version')).trim();
    for (const resolution of ['node16', 'bundler']) {
      await run(process.execPath, tsc, '-p', `tsconfig.${resolution}.json`);
      yield `${version}, ${resolution} resolution ok`;
    }
  }
}
