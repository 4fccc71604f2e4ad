// The page of the two three.js entrants: loads the scene of a view, draws it, and sends back what it
// drew. Runs in the browser; browser.py serves it and takes its answer.

import * as THREE from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';
import {mergeGeometries} from 'three/addons/utils/BufferGeometryUtils.js';
import {creased} from '/adapter/crease.js';

const kRepetitions = 5;

// Row-major rows of view.json -> a matrix of three.js.
function matrixOf(rows) {
    return new THREE.Matrix4().set(...rows.flat());
}

// A camera with the matrices of the view as they are.
function cameraOf(view) {
    const { projection, fov_y_deg, height, near, far } = view.camera;
    const aspect = view.width_px / view.height_px;
    const [x, y] = [height * aspect / 2, height / 2];
    const camera = projection === "parallel"
        ? new THREE.OrthographicCamera(-x, x, y, -y, near, far)
        : new THREE.PerspectiveCamera(fov_y_deg, aspect, near, far);
    camera.matrixAutoUpdate = camera.matrixWorldAutoUpdate = false;
    camera.matrixWorldInverse.copy(matrixOf(view.view_from_world));
    camera.matrixWorld.copy(camera.matrixWorldInverse).invert();
    camera.projectionMatrix.copy(matrixOf(view.clip_from_view));
    camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
    return camera;
}

// The positions of an object's meshes as one geometry: a glTF mesh has a primitive a material.
function geometryOf(node) {
    const parts = [];
    node.traverse(child => {
        if (!child.isMesh) return;
        const part = new THREE.BufferGeometry();
        part.setAttribute('position', child.geometry.attributes.position);
        part.setIndex(child.geometry.index);
        parts.push(part);
    });
    return parts.length === 1 ? parts[0] : mergeGeometries(parts);
}

// Every object of the file as one mesh, with normals and surfaces broken at creases.
async function loadScene(material) {
    const file = await new GLTFLoader().loadAsync('/view/mesh.glb');
    const scene = new THREE.Scene();
    const known = new Map();
    let firstSurface = 1;
    for (const node of [...file.scene.children]) {
        let key = '';
        node.traverse(child => { if (child.isMesh) key += child.geometry.uuid; });
        if (key === '') continue; // a camera
        if (!known.has(key)) known.set(key, creased(geometryOf(node)));
        const {geometry, surfaces} = known.get(key);
        const mesh = new THREE.Mesh(geometry, material);
        mesh.matrixAutoUpdate = false;
        mesh.matrix.copy(node.matrix);
        mesh.frustumCulled = false;
        const first = firstSurface;
        mesh.onBeforeRender = (_1, _2, _3, _4, used) => {
            if (!used.uniforms?.firstSurface) return;
            used.uniforms.firstSurface.value = first;
            used.uniformsNeedUpdate = true;
        };
        firstSurface += surfaces;
        scene.add(mesh);
    }
    return scene;
}

// Objects white on black, for the test of the camera.
function maskPass(renderer, scene, camera, target) {
    scene.background = new THREE.Color(0);
    scene.overrideMaterial = new THREE.MeshBasicMaterial({color: 0xffffff, side: THREE.DoubleSide});
    return {
        draw: () => {
            renderer.setRenderTarget(target);
            renderer.render(scene, camera);
        },
        isLine: red => red > 0.5,
    };
}

// One byte a pixel from the top: 255 where the value of the target is a line's.
function bytesOf(renderer, target, isLine) {
    const {width, height} = target;
    const values = new Float32Array(4 * width * height);
    renderer.readRenderTargetPixels(target, 0, 0, width, height, values);
    const bytes = new Uint8Array(width * height);
    for (let y = 0; y < height; ++y)
        for (let x = 0; x < width; ++x)
            bytes[(height - 1 - y) * width + x] = isLine(values[4 * (y * width + x)]) ? 255 : 0;
    return bytes;
}

// Draws into memory again and again; each time ends when a pixel has been read back.
function timeDraws(renderer, target, draw) {
    const pixel = new Float32Array(4);
    const times = [];
    for (let i = 0; i <= kRepetitions; ++i) {
        const start = performance.now();
        draw();
        renderer.readRenderTargetPixels(target, 0, 0, 1, 1, pixel);
        if (i > 0) times.push(performance.now() - start);  // the first one compiles the shaders
    }
    return times.sort((a, b) => a - b)[Math.floor(kRepetitions / 2)];
}

export async function drawView(query) {
    const view = await (await fetch('/view/view.json')).json();
    const {width_px: width, height_px: height} = view;
    const renderer = new THREE.WebGLRenderer();
    renderer.setPixelRatio(1);
    renderer.setSize(width, height, false);
    renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    const target = new THREE.WebGLRenderTarget(width, height, {
        type: THREE.FloatType, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter});
    const scene = await loadScene(new THREE.MeshBasicMaterial({side: THREE.DoubleSide}));
    const makePass = query.get('what') === 'mask'
        ? maskPass
        : (await import(`/pass/${query.get('pass')}`)).makePass;
    const pass = makePass(renderer, scene, cameraOf(view), target);
    const drawMs = timeDraws(renderer, target, pass.draw);
    await fetch(`/drawn?ms=${drawMs}`,
                {method: 'POST', body: bytesOf(renderer, target, pass.isLine)});
}
