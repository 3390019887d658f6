// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// What the documents refer to exists: files, headings, folders and verbs.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace hexapose::architecture {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

const fs::path kTop = HEXAPOSE_SOURCE_DIR;

std::string textOf(const fs::path& file) {
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    EXPECT_FALSE(text.str().empty()) << file;
    return text.str();
}

std::vector<fs::path> documents() {
    std::vector<fs::path> found{kTop / "README.md", kTop / "CONTRIBUTING.md"};
    for (const char* folder : {"core", "resources/manual"})
        for (const auto& entry : fs::recursive_directory_iterator(kTop / folder))
            if (entry.path().extension() == ".md")
                found.push_back(entry.path());
    return found;
}

std::vector<std::string> matches(const std::string& text, const std::regex& pattern) {
    std::vector<std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it)
        found.push_back((*it)[1]);
    return found;
}

/// "## A drive, by hand" is reached by #a-drive-by-hand.
bool hasHeading(const std::string& text, const std::string& anchor) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("#"))
            continue;
        std::string slug;
        for (const char c : line.substr(line.find(' ') + 1)) {
            if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_')
                slug += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
            else if (c == ' ')
                slug += '-';
        }
        if (slug == anchor)
            return true;
    }
    return false;
}

TEST(Documents, EveryLinkLeadsToAFileAndAHeading) {
    static const std::regex link(R"(\]\(([^)]+)\))");
    int count = 0;
    for (const fs::path& document : documents()) {
        for (const std::string& target : matches(textOf(document), link)) {
            if (target.starts_with("http"))
                continue;
            ++count;
            const std::size_t hash = std::min(target.find('#'), target.size());
            const fs::path file = hash == 0 ? document : document.parent_path() / target.substr(0, hash);
            ASSERT_TRUE(fs::exists(file)) << document << ": " << target;
            if (hash < target.size()) {
                EXPECT_TRUE(hasHeading(textOf(file), target.substr(hash + 1))) << document << ": " << target;
            }
        }
    }
    EXPECT_GT(count, 50);
}

/// The one of the package, which has the manual and the pictures beside it.
TEST(Documents, EveryLinkOfTheInstalledReadmeLeadsSomewhere) {
    static const std::regex link(R"(\]\(([^)]+)\))");
    const std::string text = textOf(HEXAPOSE_INSTALLED_README);
    int count = 0;
    for (const std::string& target : matches(text, link)) {
        ++count;
        EXPECT_TRUE(target.starts_with("manual/") || target == "pictures/console.png") << target;
        EXPECT_TRUE(fs::exists(kTop / "resources" / target)) << target;
    }
    EXPECT_GE(count, 5);
    EXPECT_THAT(text, testing::Not(HasSubstr("CONTRIBUTING")));
}

TEST(Documents, TheManualLinksOnlyToItselfAndThePicture) {
    static const std::regex link(R"(\]\(([^)]+)\))");
    for (const auto& entry : fs::directory_iterator(kTop / "resources/manual"))
        for (const std::string& target : matches(textOf(entry.path()), link))
            EXPECT_TRUE(target.find('/') == std::string::npos || target == "../pictures/console.png")
                << entry.path() << ": " << target;
}

/// In backquotes, with a folder in front: "core/machine/README.md", "tests/architecture/layers.cpp".
TEST(Documents, EverySourceFileAndFolderThatIsNamedExists) {
    static const std::regex named(
        R"(`((?:app|core|ui|tests|resources|installer|translations)/[A-Za-z0-9_./*-]*)`)");
    int count = 0;
    for (const fs::path& document : documents()) {
        for (std::string name : matches(textOf(document), named)) {
            ++count;
            const std::size_t star = name.find('*');
            const fs::path path = kTop / name.substr(0, star);
            bool exists = fs::exists(path);
            if (star != std::string::npos) // "machine_state.*": some file begins so
                for (const auto& entry : fs::directory_iterator(path.parent_path()))
                    exists = exists || entry.path().filename().string().starts_with(path.filename().string());
            EXPECT_TRUE(exists) << document << ": " << name;
        }
    }
    EXPECT_GT(count, 50);
}

/// The row of a folder in a table whose first column has the folders; empty: none.
std::string rowOf(const std::string& table, const fs::path& folder) {
    const std::size_t begin = table.find("\n| `" + folder.string() + "` |");
    return begin == std::string::npos ? "" : table.substr(begin + 1, table.find('\n', begin + 1) - begin);
}

TEST(Documents, EveryFolderIsInTheTableOfContributing) {
    const std::string text = textOf(kTop / "CONTRIBUTING.md");
    for (const char* top : {"core", "ui", "app"})
        for (const auto& entry : fs::recursive_directory_iterator(kTop / top))
            if (entry.is_directory()) {
                const fs::path folder = fs::relative(entry.path(), kTop);
                const std::string row = rowOf(text, folder.parent_path());
                EXPECT_TRUE(!rowOf(text, folder).empty() ||
                            row.find("`" + folder.filename().string() + "`") != std::string::npos)
                    << folder << " is neither a row nor named in the row of the folder it is in";
            }
}

TEST(Documents, TheReadmeStaysShort) {
    const std::string text = textOf(kTop / "README.md");
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 80);
}

} // namespace
} // namespace hexapose::architecture
