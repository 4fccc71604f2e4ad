// What the whole page knows: the runs, their images, and the parts that were declared.

/// The tables of the runs as the program packed them, and its words and colours (src/core/vocabulary.json).
const PACKED = JSON.parse(document.getElementById('data').textContent);
const VOCABULARY = PACKED.vocabulary;

let runs = [];
let viewImages = null;
const sections = [];

/// Declares a part of the page: {id, title, intro, isThere(view), draw(root, view), uses, isMain}.
/// `uses` names the choices, beside the filters, for which it must be drawn again ("time.*": all
/// that begin so). All parts but the main ones start folded.
function addSection(section) {
    sections.push(section);
}
