// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/console_options.h"

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/units.h"
#include "ui/common/language.h"
#include "ui/common/solver_choices.h"

#include <string_view>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <limits>
#include <set>

namespace hexapose {

namespace {

int baudOf(const std::string& text) {
    const auto baud = parseInteger(text);
    if (!baud || *baud <= 0 || *baud > std::numeric_limits<int>::max()) {
        throw InputError("--baud " + text, "not a baud rate, which is a whole number above zero");
    }
    return static_cast<int>(*baud);
}

QString languageOf(const std::string& text) {
    const QString code = languageFromText(QString::fromStdString(text));
    if (code.isEmpty()) {
        std::string known;
        for (const Language& language : languages()) {
            known += (known.empty() ? "" : ", ") + language.code.toStdString();
        }
        throw InputError("--language " + text, "no such language; there are " + known);
    }
    return code;
}

/// Of the envelope: millimetres or degrees.
double distanceOf(const std::string& option, const std::string& text) {
    const auto distance = parseNumber(text);
    if (!distance || !(*distance > 0.0)) {
        throw InputError(option + " " + text, "not a number above zero");
    }
    return *distance;
}

std::string methodOf(const std::string& text) {
    if (!isSolverChoice(text)) {
        std::string known;
        for (const std::string_view word : kSolverChoices) {
            known += (known.empty() ? "" : ", ") + std::string(word);
        }
        throw InputError("--method " + text, "no such method; there are " + known);
    }
    return text;
}

ThemeKind themeOf(const std::string& text) {
    const auto theme = themeFromWord(text);
    if (!theme) {
        throw InputError("--theme " + text, "no such theme; there are light, dark");
    }
    return *theme;
}

/// Walks over "--name value" and "--name=value".
class Words {
public:
    explicit Words(const std::vector<std::string>& words) : m_words(words) {}

    bool next() {
        if (m_at == m_words.size()) {
            return false;
        }
        m_name = m_words[m_at++];
        m_value.reset();
        if (const std::size_t equals = m_name.find('=');
            m_name.starts_with("--") && equals != std::string::npos) {
            m_value = m_name.substr(equals + 1);
            m_name.resize(equals);
        }
        return true;
    }
    const std::string& name() const { return m_name; }
    std::string value() {
        if (!m_value && m_at < m_words.size() && !m_words[m_at].starts_with("--")) {
            m_value = m_words[m_at++];
        }
        if (!m_value || m_value->empty()) {
            throw InputError(m_name, "needs a value");
        }
        return *m_value;
    }
    void noValue() const {
        if (m_value) {
            throw InputError(m_name, "takes no value");
        }
    }

private:
    const std::vector<std::string>& m_words;
    std::size_t m_at = 0;
    std::string m_name;
    std::optional<std::string> m_value;
};

/// The switches, which take no value; false for another option.
bool takeSwitch(ConsoleOptions& options, bool& virtualWanted, const std::string& name) {
    if (name == "--virtual") {
        virtualWanted = true;
    } else if (name == "--headless") {
        options.headless = true;
    } else if (name == "--help" || name == "-h") {
        options.help = true;
    } else if (name == "--version") {
        options.version = true;
    } else {
        return false;
    }
    return true;
}

} // namespace

ConsoleOptions parseOperatorOptions(const std::vector<std::string>& arguments) {
    ConsoleOptions options;
    ConnectionChoice serial{false, {}, ConnectionChoice{}.baud};
    bool virtualWanted = false;
    Words words(arguments);
    std::set<std::string> given;
    while (words.next()) {
        const std::string& name = words.name();
        if (!given.insert(name).second) {
            throw InputError(name, "is given twice");
        }
        if (takeSwitch(options, virtualWanted, name)) {
            words.noValue();
        } else if (name == "--port") {
            serial.port = QString::fromStdString(words.value());
        } else if (name == "--baud") {
            serial.baud = baudOf(words.value());
        } else if (name == "--platform") {
            options.platform = words.value();
        } else if (name == "--method") {
            options.method = methodOf(words.value());
        } else if (name == "--envelope-mm") {
            options.envelope.furthest.head<3>().setConstant(metresFromMm(distanceOf(name, words.value())));
        } else if (name == "--envelope-deg") {
            options.envelope.furthest.tail<3>().setConstant(radiansFromDeg(distanceOf(name, words.value())));
        } else if (name == "--log-dir") {
            options.logDirectory = words.value();
        } else if (name == "--language") {
            options.language = languageOf(words.value());
        } else if (name == "--theme") {
            options.theme = themeOf(words.value());
        } else if (name == "--output") {
            options.output = words.value();
        } else {
            throw InputError(name, "unknown option; --help lists them");
        }
    }
    if (virtualWanted && !serial.port.isEmpty()) {
        throw InputError("--port", "cannot be used together with --virtual");
    }
    if (!options.output.empty() && !options.headless) {
        throw InputError("--output", "is for --headless only");
    }
    if (!serial.port.isEmpty()) {
        options.connection = serial;
    } else if (virtualWanted || options.headless) {
        options.connection = ConnectionChoice{true, {}, serial.baud};
    }
    return options;
}

std::string operatorHelp() {
    return "Usage: hexapose [options]\n"
           "The operator console of a six-legged parallel platform.\n\n"
           "  --virtual         connect to the built-in virtual platform at once\n"
           "  --port PATH       connect to this serial port at once\n"
           "  --baud N          its baud rate (115200)\n"
           "  --platform FILE   platform file, or the name of a shipped one (laboratory)\n"
           "  --method M        forward method for this once: mpr3-nr, mpr2-nr, newton, or fsi, which "
           "follows\n"
           "                    the way of the legs in small steps (the one chosen last, at first mpr3-nr)\n"
           "  --envelope-mm E   no further from home along x, y, z, and\n"
           "  --envelope-deg E  no further in alpha, beta, gamma: such moves are refused (no limit)\n"
           "  --log-dir DIR     where the logs go\n"
           "  --language CODE   en or zh_CN (the desktop's)\n"
           "  --theme light|dark\n"
           "  --headless        without a display: run one move and a report of three attitudes, print\n"
           "                    the paths of log, report and picture\n"
           "  --output DIR      where the headless run puts report and picture (beside the log)\n"
           "  --help, --version\n\n"
           "Esc stops the motion wherever the focus is; the other keys are told under Help, Keys.\n";
}

void requireWritable(const std::filesystem::path& directory, const std::string& option) {
    const std::string where = option + " " + directory.string();
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error) {
        throw InputError(where, error.message());
    }
    if (!std::filesystem::is_directory(directory, error)) {
        throw InputError(where, "not a directory");
    }
    if (::access(directory.c_str(), W_OK | X_OK) != 0) {
        throw InputError(where, std::string("cannot be written: ") + std::strerror(errno));
    }
}

} // namespace hexapose
