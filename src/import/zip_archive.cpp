#include "import/zip_archive.h"

#include <minizip/unzip.h>

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "import/meshes/line_words.h"
#include "import/model_bytes.h"
#include "import/refusal.h"

namespace ink::import {
namespace {

constexpr std::size_t kMostNameBytes = 4096;
constexpr unsigned long kEncrypted = 1;  // of the flags of a zip file's entry

[[noreturn]] void complain_of(const std::string& name, const std::string& what) {
    throw core::Error("", "its file " + in_quotes(name) + ' ' + what, "a whole, valid zip file");
}

/// Closes the file that is open in a zip file, unless that was done.
struct OpenFile {
    void* zip;
    ~OpenFile() {
        if (zip != nullptr) unzCloseCurrentFile(zip);
    }
};

}  // namespace

void ZipArchive::Close::operator()(void* zip) const {
    unzClose(zip);
}

ZipArchive::ZipArchive(const std::filesystem::path& path) : zip_(unzOpen64(path.c_str())) {
    const auto damaged = [] {
        return core::Error(
            "", "it is cut short or no zip file: it has no whole list of files", "a zip file");
    };
    if (zip_ == nullptr) throw damaged();
    int status = unzGoToFirstFile(zip_.get());
    while (status == UNZ_OK) {
        unz_file_info64 about{};
        std::string name(kMostNameBytes, '\0');
        if (unzGetCurrentFileInfo64(
                zip_.get(), &about, name.data(), name.size(), nullptr, 0, nullptr, 0) != UNZ_OK)
            throw damaged();
        name.resize(std::min<std::size_t>(about.size_filename, kMostNameBytes));
        names_.push_back(std::move(name));
        status = unzGoToNextFile(zip_.get());
    }
    if (status != UNZ_END_OF_LIST_OF_FILE) throw damaged();
}

std::string ZipArchive::find(std::string name) const {
    name = lower_case(std::move(name));
    const auto found = std::ranges::find_if(
        names_, [&](const std::string& other) { return lower_case(other) == name; });
    return found == names_.end() ? "" : *found;
}

std::string ZipArchive::read(const std::string& name, std::uint64_t most_bytes) const {
    unz_file_info64 about{};
    if (unzLocateFile(zip_.get(), name.c_str(), 1) != UNZ_OK ||
        unzGetCurrentFileInfo64(zip_.get(), &about, nullptr, 0, nullptr, 0, nullptr, 0) != UNZ_OK)
        complain_of(name, "is missing");
    if ((about.flag & kEncrypted) != 0)
        throw Refusal("", "its file " + in_quotes(name) + " is encrypted", "plain files");
    if (unzOpenCurrentFile(zip_.get()) != UNZ_OK) complain_of(name, "cannot be unpacked");
    OpenFile open{zip_.get()};
    std::string content;
    std::string chunk(1U << 20, '\0');
    while (true) {
        const int count =
            unzReadCurrentFile(zip_.get(), chunk.data(), static_cast<unsigned>(chunk.size()));
        if (count < 0) complain_of(name, "is damaged");
        if (count == 0) break;
        content.append(chunk, 0, static_cast<std::size_t>(count));
        if (content.size() <= most_bytes) continue;
        throw core::Error("",
                          "its file " + in_quotes(name) + " is too long unpacked",
                          std::to_string(most_bytes) + " bytes at most");
    }
    open.zip = nullptr;
    if (unzCloseCurrentFile(zip_.get()) != UNZ_OK || content.size() != about.uncompressed_size)
        complain_of(name, "is damaged: its sum is wrong");
    return content;
}

}  // namespace ink::import
