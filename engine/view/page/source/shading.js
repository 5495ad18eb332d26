// @ts-check
// Surfaces are lit flat, by the sky and by a lamp that goes with the eye. That is less than three.js' own material does,
// because without a graphics card each line is paid for each pixel.

import * as THREE from 'three';

const kVertex = `
varying vec3 vEye;
varying vec3 vColor;
#include <clipping_planes_pars_vertex>
void main() {
  vec4 mvPosition = modelViewMatrix * (instanceMatrix * vec4(position, 1.0));
  vEye = mvPosition.xyz;
  vColor = instanceColor;
  gl_Position = projectionMatrix * mvPosition;
  #include <clipping_planes_vertex>
}`;

const kFragment = `
uniform vec3 up;
uniform float brightness;
varying vec3 vEye;
varying vec3 vColor;
#include <clipping_planes_pars_fragment>
const vec3 kLamp = vec3(-0.2988, 0.4268, 0.8536);
void main() {
  #include <clipping_planes_fragment>
  // Towards the eye, whichever side of the triangle that is.
  vec3 normal = normalize(cross(dFdx(vEye), dFdy(vEye)));
  float sky = 0.375 + 0.1 * dot(normal, up);
  float light = sky + 0.668 * max(dot(normal, kLamp), 0.0);
  // Colours are as a screen has them, light is not.
  gl_FragColor = vec4(brightness * vColor * pow(light, 0.4545), 1.0);
}`;

/** @param {THREE.Plane[]} cuts @param {THREE.Vector3} up what is above, in the eye's own axes */
export function surfaceMaterial(cuts, up) {
  return new THREE.ShaderMaterial(
      {vertexShader: kVertex, fragmentShader: kFragment, uniforms: {up: {value: up}, brightness: {value: 1}}, side: THREE.DoubleSide, clipping: true,
       clippingPlanes: cuts, polygonOffset: true, polygonOffsetFactor: 1.5, polygonOffsetUnits: 1.5});
}
