// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/regression/model_cache.h"
#include "core/kinematics/regression/polynomial_file.h"

#include "core/base/fnv1a.h"
#include "core/base/input_error.h"
#include "test_machines.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace hexapose;
using namespace hexapose::testing;
namespace fs = std::filesystem;

namespace {

const TrainingSpec kSmall{1, 0.01, 0.1, 500, ~std::uint64_t{0}};

const PolynomialModel& smallModel() {
    static const PolynomialModel model = *trainModel(laboratory(), kSmall);
    return model;
}

std::string complaintOf(const std::string& text, const PlatformGeometry& machine = laboratory()) {
    try {
        parseModel(text, "model.toml", machine);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

/// The model's text with one thing changed and the checksum made to fit.
std::string forged(const std::string& what, const std::string& by) {
    std::string text = formatModel(smallModel());
    text.erase(text.rfind("checksum"));
    text.replace(text.find(what), what.size(), by);
    Fnv1a hash;
    hash.add(text);
    return text + "checksum = \"fnv1a64:" + hash.hex() + "\"\n";
}

class ModelCache : public ::testing::Test {
protected:
    void SetUp() override {
        m_directory = fs::temp_directory_path() /
                      ("hexapose-cache-" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
                       '-' + std::to_string(std::random_device{}()));
    }
    void TearDown() override { fs::remove_all(m_directory); }
    std::optional<CachedModel> get() const {
        return loadOrTrainModel(laboratory(), kSmall, m_directory / "deep" / "er");
    }
    fs::path m_directory;
};

} // namespace

TEST(ModelFile, ComesBackExactly) {
    const PolynomialModel& model = smallModel();
    const PolynomialModel back = parseModel(formatModel(model), "copy", laboratory());
    EXPECT_EQ(back.coefficients(), model.coefficients());
    EXPECT_EQ(back.lengthCentre, model.lengthCentre);
    EXPECT_EQ(back.lengthScale, model.lengthScale);
    EXPECT_EQ(back.minLength, model.minLength);
    EXPECT_EQ(back.maxLength, model.maxLength);
    EXPECT_EQ(back.maxResidual, model.maxResidual);
    EXPECT_EQ(back.maxError, model.maxError);
    EXPECT_EQ(back.spec.seed, model.spec.seed);
    EXPECT_EQ(back.fingerprint(), model.fingerprint());
    EXPECT_EQ(formatModel(back), formatModel(model));
}

TEST(ModelFile, NoAlteredMissingOrAddedByteGoesUnnoticed) {
    const std::string text = formatModel(smallModel());
    for (std::size_t i = 0; i < text.size(); ++i) {
        for (const int flip : {1, 0x20, 0x80}) {
            std::string altered = text;
            altered[i] = static_cast<char>(altered[i] ^ flip);
            EXPECT_NE(complaintOf(altered), "accepted") << i;
        }
        EXPECT_NE(complaintOf(text.substr(0, i)), "accepted") << i;
        EXPECT_NE(complaintOf(std::string(text).erase(i, 1)), "accepted") << i;
        EXPECT_NE(complaintOf(std::string(text).insert(i, 1, ' ')), "accepted") << i;
    }
    EXPECT_NE(complaintOf(text + '\n'), "accepted");
    EXPECT_EQ(complaintOf(text.substr(0, 300)),
              "model.toml: the checksum does not fit; the model file is damaged or truncated");
}

TEST(ModelFile, RefusesWhatItCannotMean) {
    EXPECT_EQ(complaintOf(formatModel(smallModel()), octahedral()),
              "model.toml: the model belongs to platform " + laboratory().fingerprint() +
                  ", this platform is " + octahedral().fingerprint());
    EXPECT_EQ(complaintOf(forged("format = 1", "format = 2")), "model.toml: unknown format 2, expected 1");
    EXPECT_EQ(complaintOf(forged("degree = 1", "degree = 5")), "model.toml: degree 5 is not one of 1 to 4");
    EXPECT_EQ(complaintOf(forged("degree = 1", "degree = 2")),
              "model.toml: key \"coefficients\" has 7 monomials, expected 28");
    EXPECT_EQ(complaintOf(forged("offset_range_m = 0.01", "offset_range_m = nan")),
              "model.toml: key \"offset_range_m\" is missing or not a finite number");
    EXPECT_EQ(complaintOf(forged("samples = 500", "")),
              "model.toml: key \"samples\" is missing or not an integer");
    EXPECT_EQ(complaintOf(forged("length_scale_m = [", "length_scale_m = [1.0, ")),
              "model.toml: key \"length_scale_m\" has 7 numbers, expected 6");
    EXPECT_EQ(complaintOf(forged("length_scale_m = [", "length_scale_m = [-")),
              "model.toml: the length scales or ranges are not positive");
    EXPECT_EQ(complaintOf(forged("degree = 1", "degree = ")).rfind("model.toml:4: ", 0), 0U);
    EXPECT_EQ(complaintOf(forged("degree = 1", "degree = 1")), "accepted");
}

TEST_F(ModelCache, TrainsOnceThenReads) {
    const auto first = get(), second = get();
    EXPECT_TRUE(first->trained);
    EXPECT_FALSE(second->trained);
    EXPECT_EQ(first->file, second->file);
    EXPECT_EQ(first->model.fingerprint(), second->model.fingerprint());
    EXPECT_EQ(std::distance(fs::directory_iterator(first->file.parent_path()), {}), 1);
    TrainingSpec other = kSmall;
    other.seed = 5;
    EXPECT_TRUE(loadOrTrainModel(laboratory(), other, first->file.parent_path())->trained);
    EXPECT_TRUE(loadOrTrainModel(octahedral(), kSmall, first->file.parent_path())->trained);
}

TEST_F(ModelCache, ReplacesADamagedFile) {
    const fs::path file = get()->file;
    fs::resize_file(file, fs::file_size(file) / 2);
    EXPECT_TRUE(get()->trained);
    EXPECT_FALSE(get()->trained);
}

TEST_F(ModelCache, DoesWithoutAPlaceToKeepIt) {
    std::ofstream(m_directory) << "a file where the directory should be";
    const auto model = get();
    EXPECT_TRUE(model->trained);
    EXPECT_TRUE(model->file.empty());
    EXPECT_THROW(saveModel(model->model, m_directory / "model.toml"), InputError);
}

TEST_F(ModelCache, KeepsNothingWhenCancelled) {
    EXPECT_FALSE(
        loadOrTrainModel(laboratory(), kSmall, m_directory, [](double) { return false; }).has_value());
    EXPECT_FALSE(fs::exists(m_directory));
}
