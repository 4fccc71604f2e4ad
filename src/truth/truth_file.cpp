#include "truth/truth_file.h"

#include <cstring>
#include <limits>
#include <type_traits>

#include "core/hash.h"

namespace ink::truth {
namespace {

constexpr char kMagic[8] = {'i', 'n', 'k', 't', 'r', 'u', 't', '1'};

class Writer {
  public:
    template <class T>
    void value(const T& v) {
        items(&v, 1);
    }
    template <class T>
    void items(const T* data, std::size_t count) {
        static_assert(std::is_trivially_copyable_v<T>);
        const auto* begin = reinterpret_cast<const std::uint8_t*>(data);
        bytes.insert(bytes.end(), begin, begin + count * sizeof(T));
    }
    std::vector<std::uint8_t> bytes;
};

/// Reads what is there; past the end everything is zero and `is_good` false.
class Reader {
  public:
    explicit Reader(std::span<const std::uint8_t> bytes) : left_(bytes) {}

    template <class T>
    T value() {
        T v{};
        items(&v, 1);
        return v;
    }
    template <class T>
    void items(T* data, std::size_t count) {
        static_assert(std::is_trivially_copyable_v<T>);
        if (count > left_.size() / sizeof(T)) {
            is_good = false;
            return;
        }
        if (count > 0) std::memcpy(data, left_.data(), count * sizeof(T));
        left_ = left_.subspan(count * sizeof(T));
    }
    /// A count of things of which each takes at least `least_bytes`; 0 if they cannot all be there.
    std::size_t count(std::size_t least_bytes) {
        const auto n = value<std::uint64_t>();
        if (n <= left_.size() / least_bytes) return n;
        is_good = false;
        return 0;
    }
    [[nodiscard]] bool is_at_end() const { return left_.empty(); }
    [[nodiscard]] std::span<const std::uint8_t> left() const { return left_; }

    bool is_good = true;

  private:
    std::span<const std::uint8_t> left_;
};

struct Size {
    std::int32_t width_px = 0, height_px = 0;
};

/// Pixels as runs of equal ones: ids and labels are mostly that.
template <class T>
void write_runs(Writer& out, const core::Image<T>& image) {
    out.value(Size{image.width_px(), image.height_px()});
    for (std::size_t i = 0; i < image.size();) {
        std::uint32_t run = 1;
        while (i + run < image.size() && image.data()[i + run] == image.data()[i])
            ++run;
        out.value(run);
        out.value(image.data()[i]);
        i += run;
    }
}

template <class T>
core::Image<T> read_runs(Reader& in) {
    const auto size = in.value<Size>();
    constexpr int kMost = 1 << 20;
    if (size.width_px < 0 || size.height_px < 0 || size.width_px > kMost ||
        size.height_px > kMost) {
        in.is_good = false;
    }
    if (!in.is_good) return {};
    core::Image<T> image(size.width_px, size.height_px);
    for (std::size_t i = 0; i < image.size() && in.is_good;) {
        const auto run = in.value<std::uint32_t>();
        const T pixel = in.value<T>();
        if (run == 0 || run > image.size() - i) {
            in.is_good = false;
            break;
        }
        std::fill_n(image.data() + i, run, pixel);
        i += run;
    }
    return image;
}

/// Floats of the pixels that show a triangle; the sky has no need of any.
void write_seen(Writer& out, const core::Image<float>& image, const Layers& layers) {
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (layers.triangle.data()[i] != kNoTriangle) out.value(image.data()[i]);
    }
}

core::Image<float> read_seen(Reader& in, const Layers& layers, float sky) {
    core::Image<float> image(layers.triangle.width_px(), layers.triangle.height_px(), sky);
    for (std::size_t i = 0; i < image.size() && in.is_good; ++i) {
        if (layers.triangle.data()[i] != kNoTriangle) image.data()[i] = in.value<float>();
    }
    return image;
}

void write_curve(Writer& out, const Curve& curve) {
    out.value(curve.line_class);
    out.value(curve.kind);
    out.value(curve.empty_side);
    out.value(curve.edge);
    out.value(curve.face0);
    out.value(curve.face1);
    out.value(curve.deviation_rad);
    out.value(curve.gap);
    out.value(curve.view_angle_rad);
    out.value(curve.begin);
    out.value(curve.end);
}

Curve read_curve(Reader& in) {
    Curve curve;
    curve.line_class = in.value<LineClass>();
    curve.kind = in.value<ContourKind>();
    curve.empty_side = in.value<std::int8_t>();
    curve.edge = in.value<std::uint32_t>();
    curve.face0 = in.value<std::uint32_t>();
    curve.face1 = in.value<std::uint32_t>();
    curve.deviation_rad = in.value<float>();
    curve.gap = in.value<float>();
    curve.view_angle_rad = in.value<float>();
    curve.begin = in.value<CurvePoint>();
    curve.end = in.value<CurvePoint>();
    return curve;
}

constexpr std::size_t kCurveBytes = 3 + 6 * sizeof(std::uint32_t) + 2 * sizeof(CurvePoint);

std::vector<std::uint8_t> encode_payload(const Truth& truth) {
    Writer out;
    write_runs(out, truth.labels);
    out.value(static_cast<std::uint64_t>(truth.curves.size()));
    for (const Curve& curve : truth.curves)
        write_curve(out, curve);
    write_runs(out, truth.sampled);
    write_runs(out, truth.layers.triangle);
    write_runs(out, truth.layers.patch);
    write_seen(out, truth.layers.n_dot_v, truth.layers);
    write_seen(out, truth.layers.w, truth.layers);
    out.value(truth.counts);
    out.value(truth.trace_s);
    return std::move(out.bytes);
}

std::optional<Truth> decode_payload(std::span<const std::uint8_t> bytes) {
    Reader in(bytes);
    Truth truth;
    truth.labels = read_runs<std::uint8_t>(in);
    truth.curves.resize(in.count(kCurveBytes));
    for (Curve& curve : truth.curves)
        curve = read_curve(in);
    truth.sampled = read_runs<std::uint8_t>(in);
    truth.layers.triangle = read_runs<std::uint32_t>(in);
    truth.layers.patch = read_runs<std::uint32_t>(in);
    truth.layers.n_dot_v = read_seen(in, truth.layers, 0);
    truth.layers.w = read_seen(in, truth.layers, std::numeric_limits<float>::infinity());
    truth.counts = in.value<TruthCounts>();
    truth.trace_s = in.value<double>();
    if (!in.is_good || !in.is_at_end()) return std::nullopt;
    return truth;
}

}  // namespace

std::vector<std::uint8_t> encode_truth(const Truth& truth, const std::string& key) {
    const std::vector<std::uint8_t> payload = encode_payload(truth);
    Writer out;
    out.items(kMagic, sizeof kMagic);
    out.value(static_cast<std::uint64_t>(key.size()));
    out.items(key.data(), key.size());
    out.value(static_cast<std::uint64_t>(payload.size()));
    out.value(core::Hasher().bytes(payload.data(), payload.size()).result());
    out.items(payload.data(), payload.size());
    return std::move(out.bytes);
}

std::optional<Truth> decode_truth(std::span<const std::uint8_t> bytes, const std::string& key) {
    Reader in(bytes);
    char magic[sizeof kMagic] = {};
    in.items(magic, sizeof magic);
    std::string stored_key(in.count(1), '\0');
    in.items(stored_key.data(), stored_key.size());
    const auto size = in.value<std::uint64_t>();
    const auto hash = in.value<std::uint64_t>();
    if (!in.is_good || std::memcmp(magic, kMagic, sizeof magic) != 0 || stored_key != key ||
        size != in.left().size() ||
        hash != core::Hasher().bytes(in.left().data(), in.left().size()).result()) {
        return std::nullopt;
    }
    return decode_payload(in.left());
}

}  // namespace ink::truth
