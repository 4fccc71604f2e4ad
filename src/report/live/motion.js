// A model that moves: its poses, and what lies between two of them.

class Motion {
    constructor({poses, points, position}) {
        const placeOf = (values, at) => values.subarray(at, at + 3).join();
        const vertexAt = new Map();
        for (let i = 0; i < position.length; i += 3) vertexAt.set(placeOf(position, i), i);
        this.vertexOf = Array.from({length: points.length / 4}, (_, i) => vertexAt.get(placeOf(points, 4 * i)));
        this.points = points.slice();
        this.poses = poses;
        this.mixed = Object.fromEntries(Object.entries(poses[0]).map(([name, values]) => [name, values.slice()]));
    }

    /// Puts the vertices where they are at a time, which begins again when it is over.
    pose(renderer, time) {
        const {count, duration_s: duration} = DATA.motion;
        const at = time / duration * (count - 1) % (count - 1 + 1e-9);
        const first = Math.min(Math.floor(at), count - 2);
        for (const [name, values] of Object.entries(this.mixed)) {
            const [from, to] = [this.poses[first][name], this.poses[first + 1][name]];
            for (let i = 0; i < values.length; ++i) values[i] = from[i] + (at - first) * (to[i] - from[i]);
        }
        this.vertexOf.forEach((vertex, point) => {
            if (vertex !== undefined) this.points.set(this.mixed.position.subarray(vertex, vertex + 3), 4 * point);
        });
        renderer.move(this.mixed, this.points);
    }
}
