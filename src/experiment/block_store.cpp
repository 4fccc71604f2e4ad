#include "experiment/block_store.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <regex>
#include <sstream>

#include "core/error.h"
#include "core/hash.h"
#include "core/parse_number.h"
#include "core/toml_document.h"
#include "core/whole_file.h"
#include "harness/images/view_images.h"

namespace ink::experiment {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRecord = "block.toml";
constexpr const char* kUnfinished = ".part";
constexpr const char* kImages = "images";

/// Runs `work`; what the file system objects to becomes an Error that names `place`.
template <class Work>
void on_disk(const fs::path& place, Work work) {
    try {
        work();
    } catch (const fs::filesystem_error& error) {
        throw core::Error(place.string(),
                          fmt::format("it cannot be written: {}", error.code().message()),
                          "a writable place with room for the results");
    }
}

/// Has `make` fill a folder beside `place`, which takes its place then; nothing half made is left.
template <class Make>
void make_anew(const fs::path& place, Make make) {
    fs::path part = place;
    part += kUnfinished;
    on_disk(place, [&] {
        fs::remove_all(part);
        try {
            make(part);
            fs::remove_all(place);
            fs::rename(part, place);
        } catch (...) {
            std::error_code ignored;
            fs::remove_all(part, ignored);
            throw;
        }
    });
}

std::string record_text(const KeptBlock& block, const BlockResult& result) {
    toml::table hashes;
    for (const auto& [table, lines] : result.lines)
        hashes.insert(table, core::Hasher().text(lines).hex());
    std::ostringstream text;
    text << toml::table{{"key", block.key},
                        {"seconds", block.seconds},
                        {"faults", core::array_of(block.faults)},
                        {"tables", hashes}}
         << '\n';
    return text.str();
}

/// Whether the parts of the tables are there as they were written: after the machine lost power
/// they may not be.
bool has_tables(const toml::table& record, const fs::path& place) {
    const toml::table* tables = record["tables"].as_table();
    if (tables == nullptr) return false;
    return std::all_of(tables->begin(), tables->end(), [&](const auto& table) {
        const auto lines = core::read_whole_file(place / table.first.str());
        return lines && core::Hasher().text(*lines).hex() == table.second.value_or(std::string());
    });
}

}  // namespace

BlockStore::BlockStore(fs::path folder) : folder_(std::move(folder)), blocks_(folder_ / "blocks") {}

fs::path BlockStore::place_of(std::size_t index) const {
    return blocks_ / fmt::format("{:06}", index);
}

void BlockStore::make_folder() const {
    harness::make_out_folder(blocks_);
}

void BlockStore::write(std::size_t index, const KeptBlock& block, const BlockResult& result) const {
    make_anew(place_of(index), [&](const fs::path& part) {
        fs::create_directories(part);
        for (const auto& [table, lines] : result.lines)
            core::write_whole_file(part / table, lines);
        for (const auto& [file, bytes] : result.files) {
            fs::create_directories((part / file).parent_path());
            core::write_whole_file(part / file, bytes);
        }
        core::write_whole_file(part / kRecord, record_text(block, result));
    });
}

std::optional<KeptBlock> BlockStore::read(std::size_t index) const {
    const fs::path file = place_of(index) / kRecord;
    const auto text = core::read_whole_file(file);
    if (!text) return std::nullopt;
    const toml::table root = core::parse_toml(*text, file);
    if (!has_tables(root, place_of(index))) return std::nullopt;
    KeptBlock block;
    block.key = root["key"].value_or(std::string());
    block.seconds = root["seconds"].value_or(0.0);
    block.faults = core::texts_of(root["faults"]);
    return block;
}

std::string BlockStore::lines(std::size_t index, const std::string& table) const {
    return core::read_whole_file(place_of(index) / table).value_or("");
}

std::vector<std::size_t> BlockStore::indices() const {
    std::vector<std::size_t> found;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(blocks_, ignored)) {
        const std::string name = entry.path().filename().string();
        if (const auto index = core::parse_number<std::size_t>(name)) found.push_back(*index);
    }
    std::sort(found.begin(), found.end());
    return found;
}

void BlockStore::adopt(std::size_t index, const BlockStore& other) const {
    make_anew(place_of(index), [&](const fs::path& part) {
        fs::copy(other.place_of(index), part, fs::copy_options::recursive);
    });
}

void BlockStore::release_images(std::size_t index) const {
    const fs::path place = place_of(index);
    if (!fs::is_directory(place / kImages)) return;
    on_disk(folder_ / kImages, [&] {
        std::vector<fs::path> files;
        for (const auto& entry : fs::recursive_directory_iterator(place / kImages))
            if (entry.is_regular_file()) files.push_back(entry.path());
        for (const fs::path& file : files) {
            const fs::path target = folder_ / fs::relative(file, place);
            fs::create_directories(target.parent_path());
            fs::rename(file, target);
        }
    });
}

void BlockStore::remove_leftovers() const {
    static const std::regex kHalfWritten(R"(.*\.[0-9a-f]{16}\.part)");
    std::error_code ignored;
    std::vector<fs::path> parts;
    for (const auto& entry : fs::directory_iterator(blocks_, ignored))
        if (entry.path().extension() == kUnfinished) parts.push_back(entry.path());
    for (const auto& entry : fs::recursive_directory_iterator(folder_, ignored)) {
        if (std::regex_match(entry.path().filename().string(), kHalfWritten))
            parts.push_back(entry.path());
    }
    for (const fs::path& part : parts)
        fs::remove_all(part, ignored);
}

void BlockStore::clear() const {
    std::error_code ignored;
    fs::remove_all(blocks_, ignored);
}

FolderLock::FolderLock(const std::filesystem::path& folder, bool is_shared)
    : handle_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (handle_ < 0) return;
    // A file system without locks is no reason not to run.
    const int failed = flock(handle_, (is_shared ? LOCK_SH : LOCK_EX) | LOCK_NB);
    if (failed != 0 && errno == EWOULDBLOCK) {
        close(handle_);
        throw core::Error(folder.string(), "another run is at work here", "another --out");
    }
}

FolderLock::~FolderLock() {
    if (handle_ >= 0) close(handle_);
}

}  // namespace ink::experiment
