// Paths as wide lines, and how they are played, with both releases of three.js: what is in the buffers, what is disposed, what is refused.
import assert from 'node:assert/strict';
import { afterEach, describe, test } from 'node:test';
import { gallery } from '../../../web/gallery.js';
import { load } from '../../../web/index.js';
import { anything, refuses } from '../../helpers/refuses.js';
import { loadReleases } from '../../helpers/three-releases.js';

const surfpath = await load();
const torus = surfpath.surface(gallery.parametricTorus);
const { from, to } = gallery.parametricTorus;
const path = torus.shortestPath(from, to, { points: 20 });
const film = torus.shortestPath(from, to, { algorithm: 'polyline', start: 'straight', record: true, points: 20 });

/** Frames that were asked for and not cancelled. @type {Map<number, (now: number) => void>} */
const asked = new Map();
let last = 0;
Object.assign(globalThis, {
  requestAnimationFrame: (/** @type {(now: number) => void} */ run) => asked.set(++last, run) && last,
  cancelAnimationFrame: (/** @type {number} */ handle) => asked.delete(handle),
});
const frame = (/** @type {number} */ now) => {
  const runs = [...asked.values()];
  asked.clear();
  for (const run of runs) run(now);
};
afterEach(() => asked.clear());

for (const [title, { draw, THREE }] of await loadReleases())
  describe(title, () => {
    /** The passes of a line: hidden, halo, line. @param {InstanceType<typeof draw.GeodesicLine>} line @returns {any[]} */
    const passes = (line) => line.children[0].children;
    /** What is drawn. @param {InstanceType<typeof draw.GeodesicLine>} line */
    const shown = (line) => {
      const { instanceStart, instanceEnd } = passes(line)[2].geometry.attributes;
      const count = passes(line)[2].geometry.instanceCount;
      const at = (/** @type {any} */ attribute, /** @type {number} */ i) => [attribute.getX(i), attribute.getY(i), attribute.getZ(i)];
      return [...Array.from({ length: count }, (_, i) => at(instanceStart, i)).flat(), ...at(instanceEnd, count - 1)];
    };
    const single = (/** @type {ArrayLike<number>} */ points) => Array.from(Float32Array.from(points));

    describe('GeodesicLine', () => {
      test('holds the points of the path, and distances along it', () => {
        const line = new draw.GeodesicLine(path);
        assert.deepEqual(shown(line), single(path.points));
        const { instanceDistanceEnd } = passes(line)[0].geometry.attributes;
        const chords = torus.shortestPath(from, to, { points: 20, start: path }).length;
        assert.ok(Math.abs(instanceDistanceEnd.getX(20) - chords) < 0.01 * chords);
      });

      test('reuses its buffers for as many points, and frees them for others', () => {
        const line = new draw.GeodesicLine(path);
        const { geometry } = passes(line)[2];
        let freed = 0;
        geometry.addEventListener('dispose', () => freed++);
        const before = geometry.attributes.instanceStart.data;
        line.setPath(film);
        assert.equal(geometry.attributes.instanceStart.data, before);
        assert.deepEqual([freed, ...shown(line)], [0, ...single(film.points)]);
        line.setPath([0, 0, 0, 1, 0, 0, 1, 1, 0]);
        assert.deepEqual([freed, ...shown(line)], [1, 0, 0, 0, 1, 0, 0, 1, 1, 0]);
      });

      test('the hidden part is dashed and drawn behind the surface alone', () => {
        const [hidden, halo, line] = passes(new draw.GeodesicLine(path, { width: 5, haloWidth: 2 })).map(({ material }) => material);
        assert.ok(hidden.dashed && hidden.depthFunc === THREE.GreaterDepth && hidden.opacity < 1);
        assert.deepEqual([halo.linewidth, line.linewidth], [9, 5]);
        assert.ok(!halo.dashed && !line.dashed && [halo, line].every(({ depthFunc }) => depthFunc === THREE.LessEqualDepth));
      });

      test('the hidden part is opaque in a colour of its own, black too', () => {
        const opacity = (/** @type {InstanceType<typeof draw.GeodesicLine>} */ line) => passes(line)[0].material.opacity;
        assert.equal(opacity(new draw.GeodesicLine(path, { hiddenColour: 0x000000 })), 1);
        const line = new draw.GeodesicLine(path);
        line.setColours({ colour: 'red' });
        assert.ok(opacity(line) < 1);
        line.setColours({ hiddenColour: 'blue' });
        assert.equal(opacity(line), 1);
      });

      test('is drawn without a halo or a hidden part if asked so', () => {
        const line = new draw.GeodesicLine(path, { halo: null, hidden: false });
        assert.deepEqual(
          passes(line).map(({ visible }) => visible),
          [false, false, true],
        );
      });

      test('shows nothing for a path that was not found, and keeps quiet about its own visibility', () => {
        const lost = surfpath.surface(gallery.sphere).shortestPath([9, 0, 0], [0, 1, 0]);
        const line = new draw.GeodesicLine(lost);
        assert.equal(line.children[0].visible, false);
        line.visible = false;
        line.setPath(path);
        assert.deepEqual([line.visible, line.children[0].visible], [false, true]);
        line.setPath(null);
        assert.equal(line.children[0].visible, false);
      });

      test('refuses a path without positions, in words', () => {
        const plane = surfpath.metric({ E: 1, F: 0, G: 1, u: [0, 1], v: [0, 1] });
        const abstract = plane.shortestPath([0.1, 0.1], [0.8, 0.9]);
        assert.equal(abstract.converged, true);
        assert.throws(() => new draw.GeodesicLine(abstract), { name: 'TypeError', message: /^GeodesicLine: .*metric without positions/ });
        assert.throws(() => new draw.GeodesicLine(/** @type {any} */ ('path')), { name: 'TypeError', message: /must be a Path/ });
        assert.throws(() => new draw.GeodesicLine([1, 2, 3]), RangeError);
        assert.throws(() => new draw.GeodesicLine(path, /** @type {any} */ ({ color: 'red' })), /no option 'color'/);
      });

      test('disposes one geometry and three materials, and leaves its scene', () => {
        const [scene, line] = [new THREE.Scene(), new draw.GeodesicLine(path)];
        scene.add(line);
        const freed = new Set();
        for (const { geometry, material } of passes(line))
          for (const thing of [geometry, material]) thing.addEventListener('dispose', () => freed.add(thing));
        line.dispose();
        assert.deepEqual([freed.size, scene.children.length], [4, 0]);
      });
    });

    test('what is drawn with is checked when it is given', () => {
      const geometry = draw.surfaceGeometry(torus, { resolution: 4 });
      const [line, marker] = [new draw.GeodesicLine(path), new draw.Marker()];
      line.setColours(anything(undefined));
      const fit = (/** @type {any[]} */ ...given) => draw.fitCamera(new THREE.PerspectiveCamera(), geometry, [1, 1, 1], ...given);
      fit(0.1, [[3, 0, 0], new Float64Array(3)]);
      /** @type {[() => unknown, Function, RegExp][]} */
      const mistakes = [
        [() => draw.surfaceMaterial(geometry, anything(null)), TypeError, /^surfaceMaterial: options must be an object, not null/],
        [() => draw.surfaceMaterial(geometry, anything({ lines: 1 })), TypeError, /^surfaceMaterial: options.lines must be true or false/],
        [() => draw.surfaceMaterial(geometry, anything({ contours: 'x' })), TypeError, /options.contours must be true or false/],
        [() => draw.surfaceGeometry(torus, { colour: anything(() => Array(9409).fill('1')) }), TypeError, /must be numbers, not '1'/],
        [() => fit('0.1'), TypeError, /^fitCamera: margin must be a number in/],
        [() => fit(0.1, [9, 9, 9]), TypeError, /^fitCamera: shown must be an array of places, x y z each/],
        [() => fit(0.1, [[Number.NaN, 0, 0]]), TypeError, /^fitCamera: shown must be/],
        [() => fit(0.1, {}), TypeError, /^fitCamera: shown must be .*, not an object/],
        [() => new draw.GeodesicLine(path, anything({ hidden: 1 })), TypeError, /^GeodesicLine: options.hidden must be true or false/],
        [() => line.setColours(anything({ color: 'red' })), TypeError, /^setColours: there is no option 'color'/],
        [() => line.setOrder(anything('x')), TypeError, /^setOrder: order must be a finite number/],
        [() => line.setResolution(0, -1), RangeError, /^setResolution: height must be a number of pixels/],
        [() => marker.setRadius(-1, 2), RangeError, /^setRadius: radius must be a number of pixels/],
        [() => marker.setRadius(1, Number.NaN), RangeError, /^setRadius: ring must be a number of pixels/],
        [() => marker.setColours(anything({ color: 'red' })), TypeError, /^setColours: there is no option 'color'/],
        [() => new draw.PathPlayer(anything(null), path), TypeError, /^PathPlayer: line must be a GeodesicLine, not null/],
        [() => new draw.PathPlayer(line, path, anything({ onFrame: 5 })), TypeError, /^PathPlayer: options.onFrame must be a function/],
        [() => new draw.PathPlayer(line, path, anything({ reducedMotion: 1 })), TypeError, /options.reducedMotion must be true or false/],
      ];
      for (const [call, kind, message] of mistakes) refuses(call, kind, message);
      for (const thing of [geometry, line, marker]) thing.dispose();
    });

    describe('PathPlayer', () => {
      test('scrubs from the straight start to the path, and reddens', () => {
        const line = new draw.GeodesicLine();
        const player = new draw.PathPlayer(line, film, { cool: '#0000ff', warm: '#ff0000' });
        assert.equal(player.iterations, film.history.length);
        assert.deepEqual(shown(line), single(film.points));
        player.scrub(0);
        const [first] = film.history;
        assert.ok(first.points);
        const gap = (/** @type {number[]} */ one, /** @type {ArrayLike<number>} */ other) =>
          Math.max(...one.map((x, i) => Math.abs(x - other[i])));
        // The first iterate, spaced anew by length: on its own chords.
        assert.ok(gap(shown(line), film.points) > 0.1);
        assert.ok(gap(shown(line).slice(0, 3), first.points) < 1e-6 && gap(shown(line).slice(-3), first.points.slice(-3)) < 1e-6);
        assert.equal(passes(line)[2].material.color.getHexString(), '0000ff');
        player.scrub(0.5);
        assert.notEqual(passes(line)[2].material.color.getHexString(), '0000ff');
        player.scrub(1);
        assert.deepEqual(shown(line), single(film.points));
        assert.equal(passes(line)[2].material.color.getHexString(), 'ff0000');
        assert.throws(() => player.scrub(1.5), RangeError);
      });

      test('plays for as long as it should, slow at both ends, then stops', async () => {
        /** @type {number[]} */ const moments = [];
        const player = new draw.PathPlayer(new draw.GeodesicLine(), film, { onFrame: (moment) => moments.push(moment) });
        moments.length = 0;
        const played = player.play();
        for (const now of [5000, 5120, 5600, 6080, 6199]) frame(now);
        assert.equal(asked.size, 1);
        frame(6200);
        assert.equal(asked.size, 0);
        await played;
        assert.equal(moments.at(-1), 1);
        assert.ok(moments.every((moment, i) => i === 0 || moment >= moments[i - 1]));
        assert.ok(moments[2] < 0.05 && Math.abs(moments[3] - 0.5) < 1e-12 && moments[4] > 0.95, `${moments}`);
      });

      test('takes no time where none is given it, and refuses less', async () => {
        const player = new draw.PathPlayer(new draw.GeodesicLine(), film, { duration: 0 });
        const played = player.play();
        frame(100);
        await played;
        assert.deepEqual([player.moment, asked.size], [1, 0]);
        for (const duration of [-1, Number.NaN, Infinity])
          assert.throws(() => new draw.PathPlayer(new draw.GeodesicLine(), film, { duration }), {
            name: 'RangeError',
            message: /^PathPlayer: options.duration must be a finite number that is not negative/,
          });
      });

      test('shows the end at once for less motion, and where nothing was recorded', async () => {
        const still = new draw.PathPlayer(new draw.GeodesicLine(), film, { reducedMotion: true });
        still.scrub(0);
        await still.play();
        assert.equal(still.moment, 1);
        const plain = new draw.PathPlayer(new draw.GeodesicLine(), path);
        assert.equal(plain.iterations, 0);
        await plain.play();
        assert.equal(asked.size, 0);
      });

      test('asks for no frames after stop, dispose or another path, and says that it ended', async () => {
        for (const end of /** @type {const} */ (['stop', 'dispose', 'setPath'])) {
          const player = new draw.PathPlayer(new draw.GeodesicLine(), film);
          const played = player.play();
          frame(100);
          assert.equal(asked.size, 1);
          player[end](film);
          assert.equal(asked.size, 0, end);
          await played;
        }
      });

      test('does what it is told while it shows a frame', async () => {
        for (const end of /** @type {const} */ (['stop', 'finish', 'dispose', 'setPath']))
          for (const count of [1, 2]) {
            let frames = 0;
            const player = new draw.PathPlayer(new draw.GeodesicLine(), film, { onFrame: () => ++frames === count && player[end](film) });
            const played = player.play();
            if (count === 2) frame(100);
            assert.equal(asked.size, 0, end);
            await played;
          }
        let isOver = false;
        const again = new draw.PathPlayer(new draw.GeodesicLine(), film, { onFrame: (moment) => isOver || moment < 1 || again.play() });
        const played = again.play();
        frame(100);
        frame(2000);
        await played;
        assert.deepEqual([again.moment, asked.size], [0, 1], 'it plays in a loop');
        isOver = true;
        again.dispose();
      });

      test('leaves the line alone once it is disposed', async () => {
        const line = new draw.GeodesicLine();
        let drawn = 0;
        const player = new draw.PathPlayer(line, film, { onFrame: () => drawn++ });
        player.dispose();
        for (const use of [() => player.play(), () => player.finish(), () => player.scrub(0), () => player.setColours({ warm: 'red' })])
          await use();
        assert.deepEqual([drawn, asked.size, line.children[0].visible], [0, 0, true]);
        player.setPath(path);
        assert.equal(drawn, 1, 'it takes another path');
      });

      test('plays iterates of elements, whose numbers of points differ', () => {
        const levels = torus.shortestPath(from, to, { record: true });
        const line = new draw.GeodesicLine();
        const player = new draw.PathPlayer(line, levels);
        assert.ok(player.iterations > 0);
        player.scrub(0);
        const points = shown(line);
        assert.equal(points.length, levels.points.length);
        for (const k of [0, 1, 2]) assert.ok(Math.abs(points[k] - levels.points[k]) < 1e-5);
      });
    });
  });
