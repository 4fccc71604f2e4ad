// The methods that the page draws. Each has its shader's file; here stands what a file cannot say.

/// How large a pass draws, of a frame's size.
const sizes = {
    corners: (width, height) => [width + 1, height + 1],
    cells: (width, height) => [width, height],
    ways: (width, height) => [4 * Math.ceil(width / 8), Math.ceil(height / 4)],
};

/// `targets`: formats of the textures that the mesh is drawn into. `reads`: arrays of the mesh by the names
/// that the shader has for them; without, it reads the tables of faces and points. `hasCorners`: samples are
/// corners of pixels. `passes`: how often the mesh is drawn, with which uniforms and faces; once, both sides,
/// unless it says otherwise. `steps`: sections that draw for the next one before the lines: what they `draw` by the name
/// under which that reads it, and its format (`ofClasses` with classes); `by` which vertices, and how large of a frame's size.
/// `linesBy`: vertices of the lines. `isInk`: lines are ink of any width. `hasClasses`: it can tell the classes of its lines.
const METHODS = {
    chords: {
        targets: ['R32UI', 'R32UI'],
        hasCorners: true,
        isInk: true,
        hasClasses: true,
        steps: [{section: 'marks', by: 'screen', draws: {marks: 'R8UI'}, size: 'corners'},
            {section: 'sides', by: 'tiles', draws: {sides: 'RGBA16UI'}, ofClasses: 'RGBA32UI', size: 'corners'},
            {section: 'cells', by: 'tiles', draws: {pieces: 'RGBA32UI'}, size: 'cells'}],
        linesBy: 'tiles',
    },
    strokes: {
        targets: ['R32UI', 'R32UI'],
        hasCorners: true,
        isInk: true,
        hasClasses: true,
        steps: [{section: 'marks', by: 'screen', draws: {marks: 'R8UI'}, size: 'corners'},
            {section: 'sides', by: 'tiles', draws: {sides: 'RGBA32UI'}, size: 'corners'},
            {section: 'cells', by: 'tiles', draws: {pieces: 'RGBA32UI', exits: 'RGBA32UI'}, size: 'cells'},
            {section: 'ways', by: 'screen', draws: {ways: 'RGBA32UI'}, size: 'ways'},
            {section: 'thin', by: 'spread', draws: {thin: 'RGBA8'}, size: 'cells'}],
        linesBy: 'tiles spread',
    },
    surface_lookup: {
        targets: ['R32UI', 'R32UI'],
        hasCorners: true,
        hasClasses: true,
        steps: [{section: 'marks', by: 'screen', draws: {marks: 'R8UI'}, size: 'corners'},
            {section: 'sides', by: 'tiles', draws: {sides: 'R8UI'}, size: 'corners'}],
        linesBy: 'tiles',
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
