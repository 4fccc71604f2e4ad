// The methods that the page draws. Each has its shader's file; here stands what a file cannot say.

/// `targets`: formats of the textures that the mesh is drawn into. `reads`: arrays of the mesh by the names
/// that the shader has for them; without, it reads the tables of faces and points. `hasCorners`: samples are
/// corners of pixels. `passes`: how often the mesh is drawn, with which uniforms and faces; once, both sides,
/// unless it says otherwise. `steps`: sections that draw for the next one before the lines: under which name it reads
/// that, of which format it is (`ofClasses` with classes), and how much larger than the frame. `isInk`: lines are ink of any
/// width. `hasClasses`: it can tell the classes of its lines.
const METHODS = {
    chords: {
        targets: ['R32UI', 'R32UI'],
        hasCorners: true,
        isInk: true,
        hasClasses: true,
        steps: [{section: 'marks', draws: 'marks', format: 'R8UI', more: 1},
            {section: 'sides', draws: 'sides', format: 'RGBA16UI', ofClasses: 'RGBA32UI', more: 1},
            {section: 'cells', draws: 'pieces', format: 'RGBA32UI', more: 0}],
    },
    strokes: {
        targets: ['R32UI', 'R32UI'],
        hasCorners: true,
        isInk: true,
        steps: [{section: 'marks', draws: 'marks', format: 'R8UI', more: 1},
            {section: 'sides', draws: 'sides', format: 'RGBA32UI', more: 1},
            {section: 'cells', draws: 'pieces', format: 'RGBA32UI', more: 0}],
    },
    surface_lookup: {
        targets: ['R32UI', 'R32UI'],
        hasCorners: true,
        hasClasses: true,
        steps: [{section: 'marks', draws: 'marks', format: 'R8UI', more: 1},
            {section: 'sides', draws: 'sides', format: 'R8UI', more: 1}],
    },
    surface8: {targets: ['R8UI'], reads: {_ink: 'surface8'}, hasCorners: true},
    surface8_depth: {targets: ['R8UI', 'R32UI'], reads: {_ink: 'surface8'}, hasCorners: true},
    label8: {targets: ['R8UI'], reads: {_ink: 'label8'}, hasCorners: true},
    ids: {targets: ['RG32UI'], reads: {id: 'id'}},
    roberts: {targets: ['RGBA32UI'], reads: {normal: 'normal'}},
    decaudin: {targets: ['RGBA32UI'], reads: {normal: 'normal'}},
    mote4: {targets: ['R8UI'], reads: {normal: 'normal'}},
    inverted_hull: {
        targets: ['R8UI'],
        reads: {normal: 'hull_normal'},
        passes: [{hides: 'BACK', widthPx: 0, ink: 0}, {hides: 'FRONT', widthPx: 2, ink: 1}],
    },
};
const METHOD_NAMES = Object.keys(METHODS);
