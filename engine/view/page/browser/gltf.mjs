// Khronos' validator reads the glTF that the graze command makes of a recording: gltf.mjs GRAZE DATA.

import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join, resolve} from 'node:path';
import validator from 'gltf-validator';

const [graze, data] = process.argv.slice(2).map((path) => resolve(path));
const folder = mkdtempSync(join(tmpdir(), 'graze-gltf-'));
const run = (...words) => execFileSync(graze, words, {cwd: data, stdio: ['ignore', 'ignore', 'inherit']});

let failed = 0;
// Shapes of each kind, parts, meshes, a terrain; bodies that are there from the beginning.
for (const [scene, meshes] of [['shapes', 'meshes'], ['parts', 'meshes'], ['machine', 'meshes'], ['terrain', 'scenes']]) {
  const recording = join(folder, `${scene}.recording`), file = join(folder, `${scene}.glb`);
  run('simulate', `scenes/${scene}.json`, '--meshes', meshes, '--record', recording);
  run('view', recording, '-o', file);
  const {issues, info} = await validator.validateBytes(new Uint8Array(readFileSync(file)), {maxIssues: 20});
  assert.ok(info.animationCount > 0 && info.totalTriangleCount > 0, `${scene}: nothing moves`);
  const isRight = issues.numErrors === 0 && issues.numWarnings === 0;
  console.log(`${isRight ? 'ok     ' : 'FAILED '} ${scene}.glb: ${info.totalTriangleCount} triangles, ${issues.numErrors} errors, ${issues.numWarnings} warnings`);
  if (isRight) continue;
  ++failed;
  console.log(issues.messages.map(({code, message, pointer}) => `  ${code} ${pointer}: ${message}`).join('\n'));
}
// That it finds what is wrong.
const whole = readFileSync(join(folder, 'parts.glb'));
const broken = Buffer.from(whole.toString('latin1').replace('"componentType":5126', '"componentType":5127'), 'latin1');
assert.ok(!broken.equals(whole), 'nothing was broken');
assert.ok((await validator.validateBytes(new Uint8Array(broken))).issues.numErrors > 0, 'the validator sees no error');
rmSync(folder, {recursive: true, force: true});
process.exitCode = failed > 0 ? 1 : 0;
