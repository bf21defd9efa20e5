#include "apps/bench/table_files.h"

#include "engine/core/error.h"
#include "engine/core/file.h"

#include <fmt/format.h>

#include <cstdio>

namespace manylight {
namespace {

bool goesToStandardOutput(const std::string& file) { return file == "-"; }

void write(const std::string& file, const std::string& text) {
    if (file.empty()) return;
    if (goesToStandardOutput(file))
        fmt::print("{}", text);
    else
        writeTextFile(file, text);
}

}  // namespace

void addTableOptions(CLI::App& parser, TableFiles& files) {
    const auto add = [&](const char* option, std::string& file, const char* help) {
        parser.add_option(option, file, help)->type_name("FILE")->group("Output");
    };
    add("--text", files.text, "the table, as on standard output");
    add("--csv", files.csv, "one line a row; - for standard output");
    add("--json", files.json, "everything; - for standard output");
}

void checkTableFiles(const TableFiles& files) {
    if (goesToStandardOutput(files.csv) && goesToStandardOutput(files.json))
        failUsage("--csv - and --json -: only one of them can go to standard output");
    for (const std::string& file : {files.text, files.csv, files.json})
        if (!file.empty() && !goesToStandardOutput(file)) requireWritable(file);
}

void writeTables(const TableFiles& files, const std::string& text, const std::string& csv, const Json& json) {
    const bool isPiped = goesToStandardOutput(files.csv) || goesToStandardOutput(files.json);
    fmt::print(isPiped ? stderr : stdout, "{}", text);
    std::fflush(stdout);
    if (!files.text.empty()) writeTextFile(files.text, text);
    write(files.csv, csv);
    write(files.json, json.dump(2) + "\n");
}

}  // namespace manylight
