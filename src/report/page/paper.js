// The page on paper: everything is open and drawn, and what is wider than a sheet is made smaller.

/// The width of an A4 sheet on its side between margins of 10 mm (style.css), in CSS px.
const PAPER_PX = 1047;

let isPrinting = false;

function openForPaper() {
    isPrinting = true;
    document.documentElement.className = 'light-theme';
    for (const section of sections.filter(s => !s.node.hidden)) {
        if (section.fold) section.fold.open = true;
        if (section.isStale) drawSection(section);
    }
    for (const fold of document.querySelectorAll('main details:not([open], .picker), header details:not([open])')) {
        fold.open = true;
        fold.dataset.forPaper = '';
    }
    for (const table of document.querySelectorAll('table.data:not(.thumbs)'))
        table.style.zoom = Math.min(1, PAPER_PX / table.scrollWidth);
}

function closeAfterPaper() {
    applyTheme();
    for (const fold of document.querySelectorAll('details[data-for-paper]')) {
        fold.open = false;
        delete fold.dataset.forPaper;
    }
    for (const table of document.querySelectorAll('table.data')) table.style.zoom = '';
    openFolds();
    // Folds say that they were opened or closed when this script is done.
    setTimeout(() => { isPrinting = false; });
}

/// Prints with the thumbnails that never came into the window, too: a browser's own print waits for none.
async function printAll() {
    openForPaper();
    await Promise.all([...document.querySelectorAll('canvas.thumb')].map(drawGridThumb));
    print();
}
