// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/regression/polynomial_file.h"

#include "core/base/fnv1a.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text_file.h"
#include "core/base/toml_values.h"
#include "core/kinematics/regression/polynomial_basis.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <random>

namespace hexapose {

namespace {

constexpr std::int64_t kFormat = 1;

/// The last line of a model file, over every byte before it.
std::string checksumLine(std::string_view body) {
    Fnv1a hash;
    hash.add(body);
    return "checksum = \"fnv1a64:" + hash.hex() + "\"\n";
}

template <class Vector>
std::string formatList(const Vector& values) {
    std::string text = "[";
    for (Eigen::Index i = 0; i < values.size(); ++i)
        text += (i == 0 ? "" : ", ") + formatTomlNumber(values[i]);
    return text + ']';
}

/// Takes the fields out of the document; a field that is not as written is an error.
class Reader {
public:
    Reader(const toml::table& root, const std::string& source) : m_root(root), m_source(source) {}

    [[noreturn]] void fail(const std::string& cause) const { throw InputError(m_source, cause); }

    std::int64_t integer(std::string_view key) const {
        const toml::node* node = m_root.get(key);
        if (node == nullptr || !node->is_integer())
            fail("key \"" + std::string(key) + "\" is missing or not an integer");
        return node->value<std::int64_t>().value_or(0);
    }
    std::string text(std::string_view key) const {
        const toml::node* node = m_root.get(key);
        if (node == nullptr || !node->is_string())
            fail("key \"" + std::string(key) + "\" is missing or not text");
        return node->value<std::string>().value_or("");
    }
    double number(std::string_view key) const { return finite(m_root.get(key), key); }

    /// A list of exactly `count` numbers.
    Eigen::VectorXd list(std::string_view key, int count) const {
        return numbers(m_root.get(key), key, count);
    }

    /// A list of `count` columns of six.
    Eigen::Matrix<double, 6, Eigen::Dynamic> columns(std::string_view key, int count) const {
        const toml::array* outer = arrayOf(m_root.get(key), key, count, "monomials");
        Eigen::Matrix<double, 6, Eigen::Dynamic> result(6, count);
        for (int i = 0; i < count; ++i)
            result.col(i) = numbers(outer->get(static_cast<std::size_t>(i)), key, 6);
        return result;
    }

private:
    double finite(const toml::node* node, std::string_view key) const {
        const auto value = node != nullptr && node->is_number() ? node->value<double>() : std::nullopt;
        if (!value || !std::isfinite(*value))
            fail("key \"" + std::string(key) + "\" is missing or not a finite number");
        return *value;
    }
    const toml::array* arrayOf(const toml::node* node, std::string_view key, int count,
                               const char* what) const {
        const toml::array* list = node != nullptr ? node->as_array() : nullptr;
        if (list == nullptr || list->size() != static_cast<std::size_t>(count))
            fail("key \"" + std::string(key) + "\" has " +
                 std::to_string(list == nullptr ? 0 : list->size()) + ' ' + what + ", expected " +
                 std::to_string(count));
        return list;
    }
    Eigen::VectorXd numbers(const toml::node* node, std::string_view key, int count) const {
        const toml::array* list = arrayOf(node, key, count, "numbers");
        Eigen::VectorXd result(count);
        for (int i = 0; i < count; ++i)
            result[i] = finite(list->get(static_cast<std::size_t>(i)), key);
        return result;
    }

    const toml::table& m_root;
    const std::string& m_source;
};

std::uint64_t parseSeed(const Reader& reader) {
    const std::string text = reader.text("seed");
    std::uint64_t seed = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
    if (error != std::errc{} || end != text.data() + text.size())
        reader.fail("seed \"" + text + "\" is not a whole number");
    return seed;
}

PolynomialModel readModel(const Reader& reader, const PlatformGeometry& geometry) {
    if (const auto format = reader.integer("format"); format != kFormat)
        reader.fail("unknown format " + std::to_string(format) + ", expected " + std::to_string(kFormat));
    PolynomialModel model;
    model.platformFingerprint = reader.text("platform");
    if (model.platformFingerprint != geometry.fingerprint())
        reader.fail("the model belongs to platform " + model.platformFingerprint + ", this platform is " +
                    geometry.fingerprint());
    const std::int64_t degree = reader.integer("degree");
    if (degree < kMinDegree || degree > kMaxDegree)
        reader.fail("degree " + std::to_string(degree) + " is not one of 1 to 4");
    model.spec.degree = static_cast<int>(degree);
    model.spec.samples = reader.integer("samples");
    model.spec.seed = parseSeed(reader);
    model.spec.offsetRange = reader.number("offset_range_m");
    model.spec.angleRange = reader.number("angle_range_rad");
    model.lengthCentre = reader.list("length_centre_m", kLegCount);
    model.lengthScale = reader.list("length_scale_m", kLegCount);
    model.minLength = reader.list("min_length_m", kLegCount);
    model.maxLength = reader.list("max_length_m", kLegCount);
    model.maxResidual = reader.number("max_residual_m");
    model.maxError = reader.list("max_error_m_rad", 6);
    model.setCoefficients(reader.columns("coefficients", monomialCount(model.spec.degree)));
    if (!(model.spec.offsetRange > 0.0 && model.spec.angleRange > 0.0 && model.spec.samples > 0))
        reader.fail("the training ranges or samples are not positive");
    if (!((model.lengthScale.array() > 0.0).all() &&
          (model.minLength.array() <= model.maxLength.array()).all()))
        reader.fail("the length scales or ranges are not positive");
    if (!(model.maxResidual >= 0.0 && (model.maxError.array() >= 0.0).all()))
        reader.fail("the training errors are negative");
    return model;
}

} // namespace

std::string formatModel(const PolynomialModel& model) {
    std::string text =
        "# Regression of the pose on the leg lengths, made by Hexapose. Not to be edited.\nformat = " +
        std::to_string(kFormat) + "\nplatform = \"" + model.platformFingerprint +
        "\"\ndegree = " + std::to_string(model.spec.degree) +
        "\nsamples = " + std::to_string(model.spec.samples) + "\nseed = \"" +
        std::to_string(model.spec.seed) + // all 64 bits, which a TOML integer cannot hold
        "\"\noffset_range_m = " + formatTomlNumber(model.spec.offsetRange) +
        "\nangle_range_rad = " + formatTomlNumber(model.spec.angleRange) +
        "\nlength_centre_m = " + formatList(model.lengthCentre) +
        "\nlength_scale_m = " + formatList(model.lengthScale) +
        "\nmin_length_m = " + formatList(model.minLength) +
        "\nmax_length_m = " + formatList(model.maxLength) +
        "\nmax_residual_m = " + formatTomlNumber(model.maxResidual) +
        "\nmax_error_m_rad = " + formatList(model.maxError) + "\ncoefficients = [\n";
    for (const CoefficientRow& row : model.coefficientRows)
        text += "  " + formatList(PoseVector::Map(row.values.data())) + ",\n";
    text += "]\n";
    return text + checksumLine(text);
}

void saveModel(const PolynomialModel& model, const std::filesystem::path& file) {
    std::filesystem::path part = file;
    part += ".part-" + std::to_string(std::random_device{}()); // two programs may save at once
    const std::string text = formatModel(model);
    std::ofstream stream(part, std::ios::binary);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    std::error_code error;
    if (stream)
        std::filesystem::rename(part, file, error);
    if (!stream || error) {
        std::error_code ignored;
        std::filesystem::remove(part, ignored);
        throw InputError(file.string(), "cannot be written");
    }
}

PolynomialModel loadModel(const std::filesystem::path& file, const PlatformGeometry& geometry) {
    return parseModel(readTextFile(file), file.string(), geometry);
}

PolynomialModel parseModel(std::string_view text, const std::string& sourceName,
                           const PlatformGeometry& geometry) {
    const std::size_t lineLength = checksumLine({}).size();
    if (text.size() < lineLength)
        throw InputError(sourceName, "is not a model file, or is truncated");
    const std::string_view body = text.substr(0, text.size() - lineLength);
    if (text.substr(body.size()) != checksumLine(body))
        throw InputError(sourceName, "the checksum does not fit; the model file is damaged or truncated");
    const toml::table root = parseToml(body, sourceName);
    return readModel(Reader(root, sourceName), geometry);
}

} // namespace hexapose
