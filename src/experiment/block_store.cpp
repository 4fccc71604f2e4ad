#include "experiment/block_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <sstream>

#include "core/error.h"
#include "core/hash.h"
#include "core/whole_file.h"
#include "experiment/toml_reader.h"

namespace ink::experiment {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMagic = "inkbench block 1 ";
constexpr const char* kFaults = "faults";
constexpr const char* kExtension = ".block";

std::optional<std::string> slurp(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return std::nullopt;
    return std::string{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// A part of a block's file: its name and its length, then its bytes.
std::string part_text(const std::string& name, const std::string& bytes) {
    return fmt::format("{} {}\n{}", name, bytes.size(), bytes);
}

/// Takes a line, or so many bytes, off the front of `text`.
std::string take_line(std::string_view& text) {
    const auto end = std::min(text.find('\n'), text.size());
    std::string line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

std::string encode(const std::string& key, const KeptBlock& block) {
    std::string body = fmt::format("{}\n{}\n", key, block.seconds);
    body += part_text(kFaults, fmt::format("{}", fmt::join(block.result.faults, "\n")));
    for (const auto& [table, lines] : block.result.lines)
        body += part_text(table, lines);
    const std::string hash = core::Hasher().text(body).hex();
    return fmt::format("{}{}\n{}", kMagic, hash, body);
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::string_view rest = text;
    while (!rest.empty())
        lines.push_back(take_line(rest));
    return lines;
}

/// The checksum vouches for the form of what follows it.
std::optional<KeptBlock> decode(std::string_view text, const std::string& key) {
    const std::string heading = take_line(text);
    if (heading != fmt::format("{}{}", kMagic, core::Hasher().text(text).hex()))
        return std::nullopt;
    if (take_line(text) != key) return std::nullopt;
    KeptBlock block;
    block.seconds = std::stod(take_line(text));
    while (!text.empty()) {
        const std::string part = take_line(text);
        const auto space = part.rfind(' ');
        const std::size_t size = std::stoul(part.substr(space + 1));
        std::string bytes(text.substr(0, size));
        text.remove_prefix(size);
        if (part.substr(0, space) == kFaults) {
            block.result.faults = lines_of(bytes);
        } else {
            block.result.lines[part.substr(0, space)] = std::move(bytes);
        }
    }
    return block;
}

}  // namespace

PlanRecord record_of(const Plan& plan) {
    PlanRecord record{
        plan.name, plan.identity, plan.build, plan.times, plan.one_place, false, plan.tables, {}};
    for (const Block& block : plan.blocks)
        record.keys.push_back(block.key);
    return record;
}

void refuse_other_plan(const BlockStore& store, const PlanRecord& there, const PlanRecord& mine) {
    if (there.identity == mine.identity) return;
    const std::string what =
        there.build != mine.build
            ? fmt::format(
                  "it holds results of another build ({}; this is {})", there.build, mine.build)
            : fmt::format(
                  "it holds results of another experiment or of other settings of it "
                  "('{}', {} blocks; this is '{}', {} blocks)",
                  there.name,
                  there.keys.size(),
                  mine.name,
                  mine.keys.size());
    throw core::Error(
        store.folder().string(), what, "another --out, or --fresh to throw them away");
}

BlockStore::BlockStore(fs::path folder) : folder_(std::move(folder)), blocks_(folder_ / "blocks") {}

fs::path BlockStore::file_of(std::size_t index) const {
    return blocks_ / fmt::format("{:06}{}", index, kExtension);
}

std::optional<PlanRecord> BlockStore::read_plan() const {
    const fs::path file = folder_ / "plan.toml";
    const auto text = slurp(file);
    if (!text) return std::nullopt;
    const toml::table root = parse_toml(*text, file);
    PlanRecord record;
    record.name = root["name"].value_or(std::string());
    record.identity = root["identity"].value_or(std::string());
    record.build = root["build"].value_or(std::string());
    record.times = root["times"].value_or(true);
    record.one_place = root["one_place"].value_or(true);
    record.is_finished = root["finished"].value_or(false);
    const auto texts = [&](const char* key) {
        std::vector<std::string> found;
        if (const toml::array* array = root[key].as_array()) {
            for (const toml::node& node : *array)
                found.push_back(node.value_or(std::string()));
        }
        return found;
    };
    const std::vector<std::string> tables = texts("tables");
    const std::vector<std::string> headings = texts("headings");
    record.keys = texts("blocks");
    if (record.identity.empty() || record.keys.empty() || tables.size() != headings.size()) {
        throw core::Error(file.string(), "this is no plan of an experiment", "an unchanged file");
    }
    for (std::size_t i = 0; i < tables.size(); ++i)
        record.tables.push_back({tables[i], headings[i]});
    return record;
}

void BlockStore::make_folder() const {
    std::error_code failure;
    fs::create_directories(blocks_, failure);
    if (failure || !fs::is_directory(blocks_)) {
        throw core::Error(
            folder_.string(), "this folder cannot be made", "a writable place for --out");
    }
}

void BlockStore::write_plan(const PlanRecord& record) const {
    toml::array tables;
    toml::array headings;
    toml::array keys;
    for (const PlannedTable& table : record.tables) {
        tables.push_back(table.name);
        headings.push_back(table.heading);
    }
    for (const std::string& key : record.keys)
        keys.push_back(key);
    const toml::table root{{"name", record.name},
                           {"identity", record.identity},
                           {"build", record.build},
                           {"times", record.times},
                           {"one_place", record.one_place},
                           {"finished", record.is_finished},
                           {"tables", std::move(tables)},
                           {"headings", std::move(headings)},
                           {"blocks", std::move(keys)}};
    std::ostringstream text;
    text << "# Which experiment these results are of; written and read by inkbench.\n"
         << root << '\n';
    core::write_whole_file(folder_ / "plan.toml", text.str());
}

void BlockStore::write(std::size_t index, const std::string& key, const KeptBlock& block) const {
    core::write_whole_file(file_of(index), encode(key, block));
}

std::optional<KeptBlock> BlockStore::read(std::size_t index, const std::string& key) const {
    const auto text = slurp(file_of(index));
    return text ? decode(*text, key) : std::nullopt;
}

std::vector<std::size_t> BlockStore::indices() const {
    std::vector<std::size_t> found;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(blocks_, ignored)) {
        const std::string stem = entry.path().stem().string();
        std::size_t index = 0;
        const auto [end, status] = std::from_chars(stem.data(), stem.data() + stem.size(), index);
        const bool is_block = entry.path().extension() == kExtension && status == std::errc{} &&
                              end == stem.data() + stem.size();
        if (is_block) found.push_back(index);
    }
    std::sort(found.begin(), found.end());
    return found;
}

void BlockStore::clear() const {
    std::error_code ignored;
    fs::remove_all(blocks_, ignored);
}

}  // namespace ink::experiment
