#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace ink::import {

/// A zip file, of which single files are unpacked. What is wrong with it becomes an Error that
/// names the file in it.
class ZipArchive {
  public:
    explicit ZipArchive(const std::filesystem::path& path);

    /// The files in it, as they are spelled.
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    /// The name in it that is `name` but for upper and lower case (ASCII); empty: there is none.
    [[nodiscard]] std::string find(std::string name) const;
    /// All of a file of `names`, checked against its sum. Refuses one that is encrypted, or longer
    /// than `most_bytes`, whatever it says of its length.
    [[nodiscard]] std::string read(const std::string& name,
                                   std::uint64_t most_bytes = 1ULL << 30) const;

  private:
    struct Close {
        void operator()(void* zip) const;
    };
    std::unique_ptr<void, Close> zip_;
    std::vector<std::string> names_;
};

}  // namespace ink::import
