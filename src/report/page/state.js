// What the reader chose. It stands in the address, but only where it differs from the default, so
// that a link shows what its sender saw.

class State {
    constructor() {
        this.defaults = {};
        this.values = {};
        this.listeners = [];
        this.fromAddress = new URLSearchParams(location.hash.replace(/^#/, ''));
    }

    /// Declares a choice. Its default says what it is: a text, a number, a flag, a list, or null for
    /// a list that holds all.
    define(name, defaultValue) {
        if (name in this.defaults) return;
        this.defaults[name] = defaultValue;
        this.values[name] = defaultValue;
        const text = this.fromAddress.get(name);
        if (text !== null) this.values[name] = State.parse(text, defaultValue);
    }

    static parse(text, like) {
        if (typeof like === 'boolean') return text === '1';
        if (typeof like === 'number') return Number.isFinite(Number(text)) ? Number(text) : like;
        if (like === null || Array.isArray(like))
            return text === '' ? [] : text.split(',').map(decodeURIComponent);
        return text;
    }

    static format(value) {
        if (typeof value === 'boolean') return value ? '1' : '0';
        if (Array.isArray(value)) return value.map(encodeURIComponent).join(',');
        return String(value);
    }

    get(name) {
        return this.values[name];
    }

    isDefault(name) {
        return JSON.stringify(this.values[name]) === JSON.stringify(this.defaults[name]);
    }

    /// Changes choices and tells all who listen.
    set(changes) {
        let isChanged = false;
        for (const [name, value] of Object.entries(changes)) {
            if (JSON.stringify(this.values[name]) === JSON.stringify(value)) continue;
            this.values[name] = value;
            isChanged = true;
        }
        if (!isChanged) return;
        this.writeAddress();
        for (const listener of this.listeners) listener(Object.keys(changes));
    }

    /// Gives choices their defaults again; all of them unless `names` says which.
    reset(names = Object.keys(this.defaults)) {
        this.set(Object.fromEntries(names.map(name => [name, this.defaults[name]])));
    }

    onChange(listener) {
        this.listeners.push(listener);
    }

    /// Takes over an address that the reader typed, or went back to.
    readAddress() {
        this.fromAddress = new URLSearchParams(location.hash.replace(/^#/, ''));
        const read = {};
        for (const [name, value] of Object.entries(this.defaults)) {
            const text = this.fromAddress.get(name);
            read[name] = text === null ? value : State.parse(text, value);
        }
        this.set(read);
    }

    writeAddress() {
        const parts = [];
        // What a part of the page that was not drawn yet will ask for.
        for (const [name, text] of this.fromAddress)
            if (!(name in this.defaults)) parts.push(`${name}=${encodeURIComponent(text)}`);
        for (const [name, value] of Object.entries(this.values)) {
            if (this.isDefault(name)) continue;
            parts.push(`${name}=${encodeURIComponent(State.format(value)).replace(/%2C/g, ',')}`);
        }
        const address = parts.length ? `#${parts.join('&')}` : location.pathname + location.search;
        history.replaceState(null, '', address);
    }
}

const state = new State();
