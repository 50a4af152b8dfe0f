/**
 * Keeps what lies on a surface from being swallowed by it: in depth alone it is drawn nearer to the eye, by as many pixels' worth as a surface that slopes up
 * to 75 degrees needs. On the screen it stays where it is. (A polygon offset of the surface would do that too, but in proportion to the slope, so
 * that lines on the far side shine through at every silhouette.)
 */

/** tan 75°: a line of a half-width w reaches w tan θ below the eye's side of a surface that slopes by θ. */
const SLOPE = 3.7;

/** @param {number} halfWidth in CSS pixels */
export const liftOf = (halfWidth) => SLOPE * halfWidth;

/** GLSL: a position in clip space, brought nearer to the eye by `lift` pixels' worth. `depth` is its z in the camera's space, `height` that of the view. */
export const LIFT = /* glsl */ `
vec4 lifted(vec4 clip, float depth, float lift, float height) {
  float pixel = 2.0 * clip.w / (projectionMatrix[1][1] * height);
  vec4 near = projectionMatrix * vec4(0.0, 0.0, depth + lift * pixel, 1.0);
  clip.z = near.z / near.w * clip.w;
  return clip;
}`;

/** GLSL, after `gl_Position` was lifted: a depth by logarithms is made of another number, which is lifted as far. */
export const LOG_LIFT = /* glsl */ `
#include <logdepthbuf_vertex>
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
vFragDepth -= 2.0 * lift * gl_Position.w / (projectionMatrix[1][1] * resolution.y);
#endif`;
