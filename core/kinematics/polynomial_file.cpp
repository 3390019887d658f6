// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/kinematics/polynomial_file.h"

#include "core/geometry/fnv1a.h"
#include "core/geometry/input_error.h"
#include "core/geometry/number_text.h"
#include "core/geometry/text_file.h"
#include "core/kinematics/polynomial_basis.h"

#include <toml++/toml.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <system_error>
#include <unistd.h>

namespace hexapose {

namespace {

constexpr std::int64_t kFormat = 1;
constexpr std::string_view kChecksumStart = "checksum = \"fnv1a64:";
constexpr std::string_view kChecksumEnd = "\"\n";
constexpr std::size_t kChecksumDigits = 16;
constexpr std::array<const char*, 6> kOutputs{"x_m", "y_m", "z_m", "alpha_rad", "beta_rad", "gamma_rad"};
constexpr Eigen::Index kNumbersALine = 6;

std::string checksum(std::string_view bytes) {
    Fnv1a hash;
    hash.add(bytes);
    return hash.hex();
}

void appendArray(std::string& out, const char* key, const Eigen::Ref<const Eigen::VectorXd>& values) {
    out += std::string(key) + " = [";
    for (Eigen::Index i = 0; i < values.size(); ++i) {
        out += i == 0 ? "" : ",";
        out += i % kNumbersALine == 0 && values.size() > kNumbersALine ? "\n  " : (i == 0 ? "" : " ");
        out += formatNumber(values[i]);
    }
    out += "]\n";
}

/// The text before the checksum line; anything but an unaltered file is an error.
std::string_view checkedBody(std::string_view text, const std::string& source) {
    const std::size_t tail = kChecksumStart.size() + kChecksumDigits + kChecksumEnd.size();
    const auto refuse = [&] {
        throw InputError(source, "is truncated or altered: its checksum does not fit");
    };
    if (text.size() < tail)
        refuse();
    const std::string_view body = text.substr(0, text.size() - tail);
    const std::string expected = std::string(kChecksumStart) + checksum(body) + std::string(kChecksumEnd);
    if (text.substr(body.size()) != expected || (!body.empty() && body.back() != '\n'))
        refuse();
    return body;
}

/// Reads the keys of a model; everything that is not as it should be is an error that names the key.
class ModelReader {
public:
    ModelReader(std::string_view text, const std::string& source) : m_source(source) {
        try {
            m_table = toml::parse(text, source);
        } catch (const toml::parse_error& error) {
            throw InputError(source, static_cast<long>(error.source().begin.line),
                             std::string(error.description()));
        }
    }

    template <typename T>
    T value(const char* key) const {
        const std::optional<T> found = m_table[key].template value<T>();
        if (!found)
            refuse(key, "is missing or not of its type");
        return *found;
    }

    std::vector<double> numbers(const char* key, std::size_t count) const {
        const toml::array* array = m_table[key].as_array();
        if (!array || array->size() != count)
            refuse(key, "does not have " + std::to_string(count) + " numbers");
        std::vector<double> values;
        for (const toml::node& node : *array) {
            const std::optional<double> number = node.value<double>();
            if (!number || !std::isfinite(*number))
                refuse(key, "holds something that is not a finite number");
            values.push_back(*number);
        }
        return values;
    }

    LegLengths lengths(const char* key) const { return LegLengths(numbers(key, kLegCount).data()); }

    [[noreturn]] void refuse(const char* key, const std::string& cause) const {
        throw InputError(m_source, std::string(key) + " " + cause);
    }

private:
    std::string m_source;
    toml::table m_table;
};

} // namespace

std::string formatModel(const PolynomialModel& model) {
    std::string out = "format = " + std::to_string(kFormat) + "\n";
    out += "platform = \"" + model.platformFingerprint + "\"\n";
    out += "degree = " + std::to_string(model.spec.degree) + "\n";
    out += "offset_range_m = " + formatNumber(model.spec.offsetRange) + "\n";
    out += "angle_range_rad = " + formatNumber(model.spec.angleRange) + "\n";
    out += "samples = " + std::to_string(model.spec.samples) + "\n";
    // TOML's integers are signed: the seed goes through the bits of one.
    out += "seed = " + std::to_string(std::bit_cast<std::int64_t>(model.spec.seed)) + "\n";
    appendArray(out, "length_centre_m", model.lengthCentre);
    appendArray(out, "length_scale_m", model.lengthScale);
    appendArray(out, "min_length_m", model.minLength);
    appendArray(out, "max_length_m", model.maxLength);
    out += "max_residual_m = " + formatNumber(model.maxResidual) + "\n";
    for (int k = 0; k < 6; ++k) {
        appendArray(out, kOutputs[static_cast<std::size_t>(k)], model.coefficients.row(k).transpose());
    }
    return out + std::string(kChecksumStart) + checksum(out) + std::string(kChecksumEnd);
}

PolynomialModel parseModel(std::string_view text, const std::string& sourceName,
                           const PlatformGeometry& geometry) {
    const ModelReader reader(checkedBody(text, sourceName), sourceName);
    const auto format = reader.value<std::int64_t>("format");
    if (format != kFormat)
        reader.refuse("format", std::to_string(format) + " is not known (known: 1)");
    PolynomialModel model;
    model.platformFingerprint = reader.value<std::string>("platform");
    if (model.platformFingerprint != geometry.fingerprint())
        throw InputError(sourceName, "is a model of another platform (" + model.platformFingerprint +
                                         ", but " + geometry.name + " is " + geometry.fingerprint() + ")");
    const auto degree = reader.value<std::int64_t>("degree");
    if (degree < 1 || degree > kMaxDegree)
        reader.refuse("degree", std::to_string(degree) + " is not 1 to 4");
    model.spec.degree = static_cast<int>(degree);
    model.spec.offsetRange = reader.value<double>("offset_range_m");
    model.spec.angleRange = reader.value<double>("angle_range_rad");
    model.spec.samples = reader.value<std::int64_t>("samples");
    model.spec.seed = std::bit_cast<std::uint64_t>(reader.value<std::int64_t>("seed"));
    model.lengthCentre = reader.lengths("length_centre_m");
    model.lengthScale = reader.lengths("length_scale_m");
    if (!(model.lengthScale.minCoeff() > 0.0))
        reader.refuse("length_scale_m", "is not above 0");
    model.minLength = reader.lengths("min_length_m");
    model.maxLength = reader.lengths("max_length_m");
    model.maxResidual = reader.value<double>("max_residual_m");
    const std::size_t count = monomialCount(model.spec.degree);
    model.coefficients.resize(6, static_cast<Eigen::Index>(count));
    for (int k = 0; k < 6; ++k) {
        const std::vector<double> row = reader.numbers(kOutputs[static_cast<std::size_t>(k)], count);
        model.coefficients.row(k) =
            Eigen::Map<const Eigen::RowVectorXd>(row.data(), static_cast<Eigen::Index>(count));
    }
    return model;
}

PolynomialModel loadModel(const std::filesystem::path& file, const PlatformGeometry& geometry) {
    return parseModel(readTextFile(file), file.string(), geometry);
}

void saveModel(const PolynomialModel& model, const std::filesystem::path& file) {
    const std::string text = formatModel(model);
    const std::filesystem::path half = file.string() + "." + std::to_string(getpid()) + ".part";
    const auto refuse = [&](int number) {
        std::error_code ignored;
        std::filesystem::remove(half, ignored);
        throw InputError(file.string(), "cannot be written: " + std::generic_category().message(number));
    };
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(std::fopen(half.c_str(), "wb"), &std::fclose);
    if (!out)
        refuse(errno);
    if (std::fwrite(text.data(), 1, text.size(), out.get()) != text.size() || std::fflush(out.get()) != 0)
        refuse(errno);
    std::error_code error;
    std::filesystem::rename(half, file, error);
    if (error)
        refuse(error.value());
}

} // namespace hexapose
