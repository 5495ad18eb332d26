// @ts-check
// This tells whether a processor draws in place of a graphics card, and draws smooth borders when they are asked for.

import * as THREE from 'three';

const kNames = /swiftshader|llvmpipe|softpipe|software|basic render/i;

export function isSoftware() {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return false;
  const more = gl.getExtension('WEBGL_debug_renderer_info');
  const name = gl.getParameter(more ? more.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return kNames.test(String(name));
}

/**
 * Nothing of the page is seen through the picture: to blend the two takes a processor as long as to draw a few bodies.
 * @param {HTMLCanvasElement} canvas @param {boolean} isSmooth
 */
export function contextOf(canvas, isSmooth) {
  const context = canvas.getContext('webgl2', {alpha: false, depth: true, stencil: true, antialias: isSmooth});
  if (!context) throw new Error('no WebGL');
  return context;
}

/** Draws with four samples for each pixel, on a canvas that has one. */
export class SmoothPicture {
  constructor() {
    this.target = new THREE.WebGLRenderTarget(1, 1, {samples: 4, stencilBuffer: true, internalFormat: 'RGBA8', generateMipmaps: false});
    // Numbers as the screen has them, and blended so: of render targets three.js knows that from those of headsets alone.
    this.target.texture.colorSpace = THREE.SRGBColorSpace;
    Object.assign(this.target, {isXRRenderTarget: true});
    const material = new THREE.ShaderMaterial({
      vertexShader: 'varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }',
      fragmentShader: 'uniform sampler2D drawn; varying vec2 at; void main() { gl_FragColor = texture2D(drawn, at); }',
      uniforms: {drawn: {value: this.target.texture}}, depthTest: false, depthWrite: false,
    });
    const whole = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material);
    whole.frustumCulled = false;
    this.scene = new THREE.Scene();
    this.scene.add(whole);
    this.camera = new THREE.OrthographicCamera();
  }

  /** @param {THREE.WebGLRenderer} renderer @param {THREE.Scene} scene @param {THREE.Camera} camera */
  draw(renderer, scene, camera) {
    const {x, y} = renderer.getDrawingBufferSize(new THREE.Vector2());
    this.target.setSize(x, y);
    renderer.setRenderTarget(this.target);
    renderer.render(scene, camera);
    renderer.setRenderTarget(null);
    renderer.render(this.scene, this.camera);
  }
}
