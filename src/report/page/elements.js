// Small pieces of the page: elements, files to save, the floating card.

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

function warningBox(title, text, items) {
    return element('div', {class: 'warning', role: 'alert'},
        element('strong', {}, title), ' ', text,
        items.length ? element('ul', {}, items.map(item => element('li', {}, item))) : null);
}

/// A table of terms and what they mean.
function termList(terms) {
    return element('dl', {class: 'terms'},
        terms.map(([term, meaning]) => element('div', {}, element('dt', {}, term), element('dd', {}, meaning))));
}
