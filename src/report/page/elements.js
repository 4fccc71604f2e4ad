// Small pieces of the page: elements, controls, files to save.

/// An element with attributes and children; texts are never read as HTML.
function element(tag, attributes = {}, ...children) {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        if (value === null || value === undefined || value === false) continue;
        if (name.startsWith('on')) made.addEventListener(name.slice(2), value);
        else if (value === true) made.setAttribute(name, '');
        else made.setAttribute(name, value);
    }
    made.append(...children.flat().filter(child => child !== null && child !== undefined));
    return made;
}

/// Hands the reader a file.
function saveFile(name, type, text) {
    const address = URL.createObjectURL(new Blob([text], {type}));
    const link = element('a', {href: address, download: name});
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(address), 1000);
}

/// Copies a text, and says so on the button; where the browser forbids that, the text is saved as a file.
async function copyText(text, name, button) {
    const words = button.textContent;
    try {
        await navigator.clipboard.writeText(text);
        button.textContent = 'Copied';
    } catch {
        saveFile(name, 'text/plain', text);
        button.textContent = 'Saved';
    }
    setTimeout(() => { button.textContent = words; }, 1500);
}

/// Lines of fields as CSV (RFC 4180); null is an empty field.
function csvText(lines) {
    const field = value => {
        if (value === null || value === undefined) return '';
        const text = String(value);
        return /[",\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
    };
    return lines.map(line => line.map(field).join(',') + '\n').join('');
}

/// A button that turns something on and off and shows which.
function toggleButton(text, isOn, onToggle, title = null) {
    return element('button', {
        type: 'button',
        class: 'toggle',
        'aria-pressed': isOn ? 'true' : 'false',
        title,
        onclick: () => onToggle(!isOn),
    }, text);
}

/// Several buttons of which one is chosen; choices are [value, text] pairs.
function choiceButtons(label, choices, chosen, onChoose) {
    return element('span', {class: 'choices', role: 'group', 'aria-label': label},
        choices.map(([value, text]) => element('button', {
            type: 'button',
            class: 'toggle',
            'aria-pressed': value === chosen ? 'true' : 'false',
            onclick: () => onChoose(value),
        }, text)));
}

/// A drop-down list; choices are [value, text] pairs.
function chooser(label, choices, chosen, onChoose, isLabelShown = true) {
    const list = element('select', {'aria-label': label, onchange: event => onChoose(event.target.value)},
        choices.map(([value, text]) => element('option', {value, selected: String(value) === String(chosen)}, text)));
    return isLabelShown ? element('label', {class: 'field'}, element('span', {}, label), list) : list;
}

/// Open lists close by Escape, which leaves the focus on their names, and by a click beside them. This
/// looks before the click does its work, which may draw the list anew.
function closeLists(but) {
    for (const list of document.querySelectorAll('.picker[open]')) {
        if (list === but) continue;
        if (list.contains(document.activeElement)) list.querySelector('summary').focus();
        list.open = false;
    }
}
document.addEventListener('click', ({target}) => closeLists(target.closest('.picker')), true);
document.addEventListener('keydown', ({key}) => (key === 'Escape' ? closeLists(null) : null));

/// What `draw` puts anew into `root` stands as the reader left it: the same lists open, boxes scrolled
/// as far, and the focus on the control that they work.
function redrawInPlace(root, draw) {
    const boxes = () => [...root.querySelectorAll('.scroll, .side, .picker-list')];
    // Beside the name a list shows what is chosen, a heading how it sorts, a picture its number.
    const nameOf = node => [node.tagName, node.closest('details')?.dataset.name, node.id, node.type === 'checkbox' && node.value,
        node.closest('figure')?.id, node.dataset.method,
        node.getAttribute('aria-label') || (node.tagName === 'SUMMARY' ? '' : node.textContent.replace(/ [▾▴]$/, ''))].join();
    const named = name => [...root.querySelectorAll('button, select, input, summary, [tabindex]')].filter(node => nameOf(node) === name);
    const open = [...root.querySelectorAll('details[data-name][open]')].map(node => node.dataset.name);
    const scrolled = boxes().map(box => [box.scrollLeft, box.scrollTop]);
    const held = root.contains(document.activeElement) ? document.activeElement : null;
    const name = held && nameOf(held);
    const place = held && named(name).indexOf(held);
    draw();
    for (const node of root.querySelectorAll('details[data-name]')) if (open.includes(node.dataset.name)) node.open = true;
    boxes().slice(0, scrolled.length).forEach((box, i) => [box.scrollLeft, box.scrollTop] = scrolled[i]);
    if (held) (named(name)[place] || named(name)[0])?.focus({preventScroll: true});
}

/// What the reader must know before a number is read; more of it unfolds.
function warningBox(title, text, items, isOpen = false) {
    const words = [element('strong', {}, title), ' ', text];
    return element('div', {class: 'warning', role: 'note'}, items.length
        ? element('details', {'data-name': title, open: isOpen}, element('summary', {}, words),
            element('ul', {}, items.map(item => element('li', {}, item))))
        : words);
}

/// A table of terms and what they mean.
function termList(terms) {
    return element('dl', {class: 'terms'},
        terms.map(([term, meaning]) => element('div', {}, element('dt', {}, term), element('dd', {}, meaning))));
}
