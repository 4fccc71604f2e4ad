// The page on paper: what is open is drawn, and what is wider than a sheet is made smaller.

/// The width of an A4 sheet on its side between margins of 10 mm (style.css), in CSS px.
const PAPER_PX = 1047;

function openForPaper() {
    document.documentElement.className = 'light-theme';
    for (const section of sections.filter(s => !s.node.hidden && s.isStale && isOpen(s))) drawSection(section);
    for (const fold of document.querySelectorAll('main details:not([open], .picker, .fold), header details:not([open])')) {
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
}

/// Prints with the thumbnails that never came into the window, too: a browser's own print waits for none.
/// A sheet has room for the truth and seven methods (style.css).
async function printAll() {
    openForPaper();
    await Promise.all([...document.querySelectorAll('td:nth-child(-n + 9) canvas.thumb')].map(drawGridThumb));
    print();
}
