#include "engine/core/file.h"

#include "engine/core/error.h"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <system_error>

namespace manylight {

namespace fs = std::filesystem;

namespace {

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

}  // namespace

void requireWritable(const fs::path& target) {
    const fs::path folder = folderOf(target);
    if (!fs::is_directory(folder)) fail("{}: cannot write: folder {} does not exist", target.string(), folder.string());
    if (fs::is_directory(target)) fail("{}: cannot write: it is a folder", target.string());
    if (::access(folder.c_str(), W_OK) != 0)
        fail("{}: cannot write: no permission to write in folder {}", target.string(), folder.string());
}

void writeAtomically(const fs::path& target, const std::function<void(const fs::path&)>& write) {
    requireWritable(target);
    // The extension stays last: writers choose their format by it.
    const fs::path temporary =
        folderOf(target) / fmt::format(".{}.{}{}", target.stem().string(), ::getpid(), target.extension().string());
    try {
        write(temporary);
        fs::rename(temporary, target);
    } catch (const fs::filesystem_error& error) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        fail("{}: cannot write: {}", target.string(), error.code().message());
    } catch (...) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw;
    }
}

void writeTextFile(const fs::path& target, std::string_view text) {
    writeAtomically(target, [&](const fs::path& temporary) {
        std::ofstream stream(temporary, std::ios::binary);
        stream.write(text.data(), static_cast<std::streamsize>(text.size()));
        stream.close();
        if (!stream) fail("{}: cannot write (permission denied or disk full)", target.string());
    });
}

bool isRegularFile(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

std::string readTextFile(const fs::path& source) {
    std::error_code ignored;
    const fs::file_type type = fs::status(source, ignored).type();
    if (type == fs::file_type::directory) fail("{}: is a folder, expected a file", source.string());
    if (type == fs::file_type::character || type == fs::file_type::block || type == fs::file_type::fifo)
        fail("{}: is a device or a pipe, expected a file", source.string());
    std::ifstream stream(source, std::ios::binary);
    if (!stream) fail("{}: cannot open file", source.string());
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (stream.bad()) fail("{}: cannot read file", source.string());
    return text;
}

}  // namespace manylight
