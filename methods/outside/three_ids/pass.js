// Surface ids drawn flat, and the Sobel operator of three.js' examples over them: any response is a
// line.

import * as THREE from 'three';
import {FullScreenQuad} from 'three/addons/postprocessing/Pass.js';
import {SobelOperatorShader} from 'three/addons/shaders/SobelOperatorShader.js';

function idMaterial() {
    return new THREE.ShaderMaterial({
        side: THREE.DoubleSide,
        uniforms: {firstSurface: {value: 0}},
        vertexShader: `
            attribute float surface;
            uniform float firstSurface;
            flat varying float id;
            void main() {
                id = firstSurface + surface;
                gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
            }`,
        fragmentShader: `
            flat varying float id;
            void main() { gl_FragColor = vec4(id, 0.0, 0.0, 1.0); }`,
    });
}

export function makePass(renderer, scene, camera, target) {
    const {width, height} = target;
    scene.background = new THREE.Color(0);
    scene.overrideMaterial = idMaterial();
    const ids = target.clone();
    const material = new THREE.ShaderMaterial({...SobelOperatorShader,
        uniforms: THREE.UniformsUtils.clone(SobelOperatorShader.uniforms)});
    material.uniforms.tDiffuse.value = ids.texture;
    material.uniforms.resolution.value.set(width, height);
    const sobel = new FullScreenQuad(material);
    return {
        draw: () => {
            renderer.setRenderTarget(ids);
            renderer.render(scene, camera);
            renderer.setRenderTarget(target);
            sobel.render(renderer);
        },
        isLine: red => red > 0.5,
    };
}
