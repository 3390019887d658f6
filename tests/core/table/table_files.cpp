// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "tests/core/table/table_files.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <fstream>

namespace hexapose::testing_support {

namespace fs = std::filesystem;

Folder::Folder() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    m_path = fs::path(testing::TempDir()) /
             ("hexapose_table_" + std::string(test->test_suite_name()) + "_" + test->name());
    fs::remove_all(m_path);
    fs::create_directories(m_path);
}

Folder::~Folder() {
    std::error_code ignored;
    fs::remove_all(m_path, ignored);
}

fs::path Folder::write(const std::string& name, const std::string& content) const {
    std::ofstream(m_path / name, std::ios::binary) << content;
    return m_path / name;
}

std::shared_ptr<const Table> tableOf(const std::string& content, const std::string& name) {
    const Folder folder;
    return loadTable(folder.write(name, content));
}

std::vector<double> numbersOf(const Table& table, const std::string& column) {
    std::vector<double> numbers;
    const auto index = table.find(column);
    EXPECT_TRUE(index) << column;
    for (Row row = 0; index && row < table.rowCount(); ++row)
        numbers.push_back(table.columns()[*index].number(row));
    return numbers;
}

std::vector<std::string> wordsOf(const Table& table, const std::string& column) {
    std::vector<std::string> words;
    const auto index = table.find(column);
    EXPECT_TRUE(index) << column;
    for (Row row = 0; index && row < table.rowCount(); ++row)
        words.emplace_back(table.columns()[*index].word(row));
    return words;
}

std::vector<std::string> problemsOf(const Table& table) {
    std::vector<std::string> problems;
    for (const Problem& problem : table.problems().first)
        problems.push_back(std::to_string(problem.line) + ": " + toWords(problem));
    return problems;
}

std::vector<std::string> namesOf(const Table& table) {
    std::vector<std::string> names;
    for (const Column& column : table.columns())
        names.push_back(column.info().name);
    return names;
}

void expectSame(const Table& a, const Table& b) {
    ASSERT_EQ(a.rowCount(), b.rowCount());
    ASSERT_EQ(namesOf(a), namesOf(b));
    for (std::size_t i = 0; i < a.columns().size(); ++i)
        for (Row row = 0; row < a.rowCount(); ++row) {
            const double x = a.columns()[i].number(row), y = b.columns()[i].number(row);
            ASSERT_TRUE(x == y || (std::isnan(x) && std::isnan(y))) << namesOf(a)[i] << ", row " << row;
            ASSERT_EQ(a.columns()[i].word(row), b.columns()[i].word(row));
        }
    for (Row row = 0; row < a.rowCount(); ++row)
        ASSERT_EQ(a.lineOf(row), b.lineOf(row));
    EXPECT_EQ(problemsOf(a), problemsOf(b));
}

std::string gzip(const std::string& text) {
    z_stream stream{};
    EXPECT_EQ(deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY), Z_OK);
    std::string out(deflateBound(&stream, text.size()) + 64, '\0');
    std::string in = text;
    stream.next_in = reinterpret_cast<Bytef*>(in.data());
    stream.avail_in = static_cast<uInt>(in.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}

std::string utf16(const std::string& ascii, bool bigEndian) {
    std::string out = bigEndian ? "\xFE\xFF" : "\xFF\xFE";
    for (const char c : ascii) {
        if (bigEndian)
            out += '\0';
        out += c;
        if (!bigEndian)
            out += '\0';
    }
    return out;
}

} // namespace hexapose::testing_support
