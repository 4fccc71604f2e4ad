// The page of the entrant cesium_edges: CesiumJS loads a model with EXT_mesh_primitive_edge_visibility,
// draws its edges black on white, and what it drew is sent back.

const kRepetitions = 5;
// One px has gaps where an edge lies half on what is behind it.
const kLineWidth_px = 2;
// Cesium's nearest plane is fixed; a view's own is put there by the size of the world.
const kNear_m = 100;
// Where the view's origin stands: off the middle of the earth, of which some functions ask for the height.
const kPlace = new Cesium.Cartesian3(1e7, 0, 0);

function makeScene(view) {
    const canvas = document.createElement('canvas');
    canvas.width = view.width_px;
    canvas.height = view.height_px;
    canvas.style.cssText = `width: ${view.width_px}px; height: ${view.height_px}px`;
    document.body.append(canvas);
    const scene = new Cesium.Scene({
        canvas, contextOptions: {webgl: {antialias: false, alpha: false, preserveDrawingBuffer: true}},
        msaaSamples: 1});
    for (const part of ['skyBox', 'skyAtmosphere', 'sun', 'moon'])
        scene[part] = scene[part] && scene[part].destroy() && undefined;
    scene.backgroundColor = Cesium.Color.WHITE;
    scene.highDynamicRange = false;
    scene.fog.enabled = false;
    scene.postProcessStages.fxaa.enabled = false;
    scene.rethrowRenderErrors = true;
    return scene;
}

// The view's camera, everything `scale` times as large.
function placeCamera(scene, view, scale) {
    const {projection, fov_y_deg, height, near, far} = view.camera;
    const aspect = view.width_px / view.height_px;
    const frustum = projection === 'parallel'
        ? new Cesium.OrthographicFrustum({width: height * aspect * scale, aspectRatio: aspect})
        : new Cesium.PerspectiveFrustum({  // its angle is that of the longer side
            fov: 2 * Math.atan(Math.tan(fov_y_deg * Math.PI / 360) * Math.max(1, aspect)), aspectRatio: aspect});
    frustum.near = near * scale;
    frustum.far = far * scale;
    scene.camera.frustum = frustum;
    const rows = view.view_from_world;
    const direction = new Cesium.Cartesian3(-rows[2][0], -rows[2][1], -rows[2][2]);
    const up = new Cesium.Cartesian3(rows[1][0], rows[1][1], rows[1][2]);
    const eye = [0, 1, 2].map(i => -rows.slice(0, 3).reduce((sum, row) => sum + row[i] * row[3], 0) * scale);
    const destination = Cesium.Cartesian3.add(kPlace, new Cesium.Cartesian3(...eye), new Cesium.Cartesian3());
    scene.camera.setView({destination, orientation: {direction, up}});
}

// A GLB whose edges are black lines of that width. CesiumJS takes the colour of edges from a material of
// their own, and their width from that of the faces.
function withInk(glb, width_px) {
    const jsonBytes = new DataView(glb).getUint32(12, true);
    const gltf = JSON.parse(new TextDecoder().decode(new Uint8Array(glb, 20, jsonBytes)));
    gltf.materials = [
        {extensions: {BENTLEY_materials_line_style: {width: width_px}}},
        {pbrMetallicRoughness: {baseColorFactor: [0, 0, 0, 1]}}];
    gltf.extensionsUsed.push('BENTLEY_materials_line_style');
    for (const primitive of gltf.meshes.flatMap(mesh => mesh.primitives)) {
        primitive.material = 0;
        const edges = primitive.extensions?.EXT_mesh_primitive_edge_visibility;
        if (edges) edges.material = 1;
    }
    let text = JSON.stringify(gltf);
    text += ' '.repeat((4 - new TextEncoder().encode(text).length % 4) % 4);
    const json = new TextEncoder().encode(text);
    const rest = new Uint8Array(glb, 20 + jsonBytes);
    const made = new Uint8Array(20 + json.length + rest.length);
    made.set(new Uint8Array(glb, 0, 20));
    made.set(json, 20);
    made.set(rest, 20 + json.length);
    new DataView(made.buffer).setUint32(8, made.length, true);
    new DataView(made.buffer).setUint32(12, json.length, true);
    return made;
}

async function loadModel(scene, scale, isMask) {
    const gltf = withInk(await (await fetch('/view/edges.glb')).arrayBuffer(), kLineWidth_px);
    const color = isMask ? 'vec3(0.0)' : 'vec3(1.0)';
    const model = await Cesium.Model.fromGltfAsync({
        gltf, basePath: '/view/', upAxis: Cesium.Axis.Z, forwardAxis: Cesium.Axis.X,
        modelMatrix: Cesium.Matrix4.fromTranslationRotationScale(
            new Cesium.TranslationRotationScale(kPlace, undefined, new Cesium.Cartesian3(scale, scale, scale))),
        backFaceCulling: false, incrementallyLoadTextures: false,
        edgeDisplayMode: isMask ? Cesium.EdgeDisplayMode.SURFACES_ONLY : Cesium.EdgeDisplayMode.SURFACES_AND_EDGES,
        customShader: new Cesium.CustomShader({
            lightingModel: Cesium.LightingModel.UNLIT,
            fragmentShaderText:
                `void fragmentMain(FragmentInput fsInput, inout czm_modelMaterial material) {
                     material.diffuse = ${color};
                 }`})});
    model.errorEvent.addEventListener(fail);
    scene.primitives.add(model);
    return model;
}

// Renders until the model has all that it draws with.
async function untilReady(scene, model) {
    for (let i = 0; i < 2000 && !model.ready; ++i) {
        scene.render();
        await new Promise(resolve => setTimeout(resolve, 5));
    }
    if (!model.ready) throw new Error('the model never became ready');
    for (let i = 0; i < 3; ++i) scene.render();
}

// 255 where a pixel is dark, from the top.
function bytesOf(scene, {width_px: width, height_px: height}) {
    const gl = scene.context._gl;
    const values = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, values);
    const bytes = new Uint8Array(width * height);
    for (let y = 0; y < height; ++y)
        for (let x = 0; x < width; ++x)
            bytes[(height - 1 - y) * width + x] = values[4 * (y * width + x)] < 128 ? 255 : 0;
    return bytes;
}

function timeDraws(scene) {
    const gl = scene.context._gl;
    const pixel = new Uint8Array(4);
    const times = [];
    for (let i = 0; i < kRepetitions; ++i) {
        const start = performance.now();
        scene.render();
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
        times.push(performance.now() - start);
    }
    return times.sort((a, b) => a - b)[Math.floor(kRepetitions / 2)];
}

async function drawView(query) {
    const view = await (await fetch('/view/view.json')).json();
    const scale = kNear_m / view.camera.near;
    const scene = makeScene(view);
    placeCamera(scene, view, scale);
    const model = await loadModel(scene, scale, query.get('what') === 'mask');
    await untilReady(scene, model);
    const drawMs = timeDraws(scene);
    await fetch(`/drawn?ms=${drawMs}`, {method: 'POST', body: bytesOf(scene, view)});
}
