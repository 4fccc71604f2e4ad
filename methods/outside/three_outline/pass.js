// Depth and normal edges as three.js' own examples draw them: RenderPixelatedPass with pixels of 1 px
// and its own strengths. It darkens or lightens a flat grey image at an edge; both are lines.

import * as THREE from 'three';
import {RenderPixelatedPass} from 'three/addons/postprocessing/RenderPixelatedPass.js';

const kGrey = 0.5;

export function makePass(renderer, scene, camera, target) {
    // The pass takes the background of its normals too from here: this blue is one towards the eye.
    scene.background = new THREE.Color(kGrey, kGrey, 1);
    scene.traverse(node => { if (node.isMesh) node.material.color.setRGB(kGrey, kGrey, kGrey); });
    const pass = new RenderPixelatedPass(1, scene, camera);
    pass.normalMaterial.side = THREE.DoubleSide;
    pass.setSize(target.width, target.height);
    return {
        draw: () => pass.render(renderer, target),
        isLine: red => Math.abs(red / kGrey - 1) > 0.02,
    };
}
