// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Bad files and bad options of every command: exit status 2, one line that says what, where and why.
#include "tests/app/bad_call.h"
#include "tests/app/foreign_controller.h"
#include "tests/app/machine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace hexapose::apptest {
namespace {

namespace fs = std::filesystem;

const std::string kLengthHeader = "l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_mm\n";
const std::string kLengths = kLengthHeader + "339.5,336.5,336.6,329.2,345.1,334.5\n";
const std::string kPoses = "x_mm,y_mm,z_mm,alpha_deg,beta_deg,gamma_deg\n12,-4,40,0,0,5\n";

struct Files : Scratch {
    Files() {
        file("poses.csv", kPoses);
        file("lengths.csv", kLengths);
        file("empty.csv", "");
        file("blank.csv", "\n\n");
        file("half.csv", "l1_mm,l2_mm,l3_mm,l4_mm,l5_mm\n1,2,3,4,5\n");
        file("twice.csv", "l1_mm,l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_mm\n");
        file("semicolons.csv", "l1_mm;l2_mm;l3_mm;l4_mm;l5_mm;l6_mm\n1;2;3;4;5;6\n");
        file("quote.csv", kLengthHeader + "1,2,3,4,5,6\n\"1,2\n3,4,5,6\n");
        file("utf16.csv", std::string("\xFF\xFEl\0001\0", 6));
        file("other.toml", octahedral().toml());
        file("recorded.csv", "time_s," + kLengthHeader);
        file("plain", "a regular file\n");
        fs::create_directory(path("directory"));
    }
};

void expectCliRefused(const Scratch& scratch, const std::vector<BadCall>& calls) {
    expectRefused(HEXAPOSE_CLI, scratch, calls);
}

TEST(BadOptions, OfEveryCommand) {
    const Files files;
    std::vector<BadCall> calls{
        {"", {"missing command"}},
        {"fly", {"unknown command", "fly"}},
        {"--fly", {"--fly"}},
        {"reproduce table9 --out @out",
         {"table9", "table2, table3, table4, table5, figure3, figure5, figure13, figure15, figure16, all"}},
        {"reproduce figure8 --out @out", {"figure8", "known"}},
        {"reproduce '' --out @out", {"known"}},
        {"reproduce table2 table3 --out @out", {"unexpected", "table3"}},
        {"reproduce all --out @out --platform @other.toml", {"--platform", "laboratory"}},
        {"reproduce figure3 --out @out --platform @other.toml", {"--platform", "laboratory"}},
        {"reproduce", {"reproduce", "missing"}},
        {"reproduce table5", {"--out"}},
        {"reproduce table5 --out @plain/out", {"@plain"}},
        {"reproduce figure3 --out @plain", {"@plain"}},
        {"reproduce figure3 --out", {"out"}},
    };
    const std::vector<std::string> good{"inverse @poses.csv",
                                        "forward @lengths.csv --method newton",
                                        "train --samples 500 --degree 1 --out @model",
                                        "simulate --protocol line",
                                        "run --port virtual --targets @poses.csv --log @log.csv",
                                        "report @recorded.csv --out @out",
                                        "track --drive @recorded.csv --out @out",
                                        "reproduce all --out @out"};
    for (const std::string& command : good) {
        const std::string name = command.substr(0, command.find(' '));
        calls.push_back({command + " --colour", {name, "colour"}});
        calls.push_back({command + " --colour red", {name, "colour"}});
        calls.push_back({command + " --platform", {"platform"}});
        calls.push_back({command + " --platform ''", {"platform"}});
        calls.push_back({command + " --platform nowhere", {"nowhere", "no such platform"}});
        calls.push_back({command + " --platform @missing.toml", {"@missing.toml", "no such"}});
        calls.push_back({command + " --platform @directory", {"@directory"}});
        calls.push_back({command + " --platform @plain", {"@plain:1:"}});
        calls.push_back({command + " --platform @empty.csv", {"@empty.csv:1:", "format"}});
        calls.push_back({command + " surplus", {name, "surplus"}});
        calls.push_back({command + " --platform laboratory --platform=laboratory", {"--platform", "twice"}});
    }
    expectCliRefused(files, calls);
}

TEST(BadOptions, OfInverseAndForward) {
    const Files files;
    std::vector<BadCall> calls;
    for (const std::string command : {"inverse", "forward"}) {
        const std::string column = command == "inverse" ? "x_mm" : "l6_mm";
        calls.push_back({command, {command, "missing"}});
        calls.push_back({command + " ''", {}});
        calls.push_back({command + " @missing.csv", {"@missing.csv", "No such file"}});
        calls.push_back({command + " @directory", {"@directory", "directory"}});
        calls.push_back({command + " @plain/under.csv", {"@plain/under.csv"}});
        calls.push_back({command + " @empty.csv", {"@empty.csv", "empty"}});
        calls.push_back({command + " @blank.csv", {"@blank.csv", "empty"}});
        calls.push_back({command + " @half.csv", {"@half.csv:1:", column, "missing"}});
        calls.push_back({command + " @semicolons.csv", {"@semicolons.csv:1:", "comma"}});
        calls.push_back({command + " @utf16.csv", {"@utf16.csv:1:", "UTF-8"}});
        calls.push_back({command + " -", {"standard input", "empty"}});
        calls.push_back({command + " -", {"standard input", "missing"}, "a,b\n1,2\n"});
    }
    const std::string forward = "forward @lengths.csv ";
    const std::vector<BadCall> more{
        {"forward @twice.csv", {"@twice.csv:1:", "l1_mm", "twice"}},
        {"forward @quote.csv --method newton", {"@quote.csv:3:", "quote"}},
        {forward + "--method", {"method"}},
        {forward + "--method magic", {"--method", "magic", "mpr3-nr"}},
        {forward + "--method Newton", {"--method", "Newton"}},
        {forward + "--method mpr4", {"--method", "mpr4"}},
        {forward + "--method magic", {"mpr3-nr, fsi"}},
        {forward + "--method fsi --steps 0", {"--steps", "0"}},
        {forward + "--method fsi --steps -5", {"--steps", "-5"}},
        {forward + "--method fsi --steps 1e3", {"--steps", "1e3"}},
        {forward + "--method fsi --steps", {"steps"}},
        {forward + "--method fsi --form ajar", {"--form", "ajar"}},
        {forward + "--method fsi --form ''", {"--form"}},
        {forward + "--method fsi --model @plain", {"--model", "fsi"}},
        {forward + "--method fsi --max-iterations 5", {"--max-iterations", "--steps"}},
        {forward + "--method newton --steps 5", {"--steps", "newton"}},
        {forward + "--form open", {"--form", "mpr3-nr"}},
        {forward + "--start nowhere", {"--start", "nowhere"}},
        {forward + "--tolerance-mm zero", {"--tolerance-mm", "zero"}},
        {forward + "--tolerance-mm 0", {"--tolerance-mm", "0"}},
        {forward + "--tolerance-mm -1", {"--tolerance-mm", "-1"}},
        {forward + "--tolerance-mm nan", {"--tolerance-mm", "nan"}},
        {forward + "--tolerance-mm 0,1", {"--tolerance-mm", "0,1"}},
        {forward + "--tolerance-mm", {"tolerance-mm"}},
        {forward + "--max-iterations 0", {"--max-iterations", "0"}},
        {forward + "--max-iterations -3", {"--max-iterations", "-3"}},
        {forward + "--max-iterations 2.5", {"--max-iterations", "2.5"}},
        {forward + "--max-iterations many", {"--max-iterations", "many"}},
        {forward + "--method newton --model @plain", {"--model", "newton"}},
        {forward + "--model @missing.toml", {"@missing.toml"}},
        {forward + "--model @directory", {"@directory"}},
        {forward + "--model @empty.csv", {"@empty.csv"}},
        {forward + "--model @plain", {"@plain"}},
    };
    calls.insert(calls.end(), more.begin(), more.end());
    expectCliRefused(files, calls);
}

TEST(BadOptions, OfTrack) {
    const Files files;
    const std::string legs = "time_s,l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_mm\n";
    const std::string home = ",299.9,299.9,299.9,299.9,299.9,299.9\n";
    files.file("drive.csv", legs + "0" + home + "1" + home);
    files.file("one.csv", legs + "0" + home);
    files.file("back.csv", legs + "0" + home + "0" + home);
    files.file("nan.csv", legs + "0" + home + "1,299.9,nan,299.9,299.9,299.9,299.9\n");
    files.file("negative.csv", legs + "0" + home + "1,299.9,-2,299.9,299.9,299.9,299.9\n");
    files.file("short.csv", legs + "0" + home + "1,299.9\n2" + home);
    files.file("rate.csv", "l1_mm_per_s," + legs + "0,0" + home + "0,1" + home);
    files.file("far.csv", legs + "0,400,320,400,320,400,320\n1" + home);
    files.file("bad.toml", "format = 1\nname = \"no\"\n");
    const std::string track = "track --out @out --drive ";
    expectCliRefused(
        files,
        {
            {"track --drive reference", {"--out"}},
            {"track --out @out", {"--drive"}},
            {track + "reference --steps 0", {"--steps", "0"}},
            {track + "reference --steps 1000001", {"--steps"}},
            {track + "reference --form ajar", {"--form", "ajar"}},
            {track + "reference --rates wild", {"--rates", "wild"}},
            {track + "reference --mechanism 7-ups", {"7-ups", "no such mechanism"}},
            {track + "reference --mechanism ''", {"--mechanism"}},
            {track + "reference --mechanism @bad.toml", {"@bad.toml:1:", "actuator"}},
            {track + "reference --mechanism @plain", {"@plain:1:"}},
            {track + "reference --mechanism 3-rps --platform laboratory", {"--mechanism", "--platform"}},
            {track + "reference --platform laboratory", {"--drive", "no reference drive"}},
            {track + "@missing.csv", {"@missing.csv"}},
            {track + "@empty.csv", {"@empty.csv", "empty"}},
            {track + "@lengths.csv", {"@lengths.csv:1:", "time_s"}},
            {track + "@drive.csv --mechanism 6-pus", {"@drive.csv:1:", "s1_mm"}},
            {track + "@one.csv", {"@one.csv", "two rows"}},
            {track + "@back.csv", {"@back.csv:3:", "rise"}},
            {track + "@nan.csv", {"@nan.csv:3:", "l2_mm", "nan"}},
            {track + "@negative.csv", {"@negative.csv:3:", "l2_mm"}},
            {track + "@short.csv", {"@short.csv:3:", "fields"}},
            {track + "@rate.csv", {"@rate.csv:1:", "l1_mm_per_s2"}},
            {track + "@far.csv", {"drive", "singular"}},
            {"track --drive reference --steps 10 --out @plain/out", {"@plain"}},
        });
}

TEST(BadOptions, ModelsThatDoNotBelongOrAreNotWhole) {
    const Files files;
    const std::string model = files.path("model");
    ASSERT_EQ(cli({"train", "--degree", "3", "--samples", "3000", "--range-mm", "50", "--range-deg", "15",
                   "--seed", "7", "--out", model})
                  .status,
              0);
    const Outcome good = cli({"forward", "-", "--method", "mpr3-nr", "--model", model}, kLengths);
    EXPECT_EQ(good.status, 0) << good.err;
    EXPECT_NEAR(Table(good.out).number(0, "z_mm"), 39.78, 0.5e-2);

    const std::string text = readText(model);
    const Outcome again = cli({"train", "--degree", "3", "--samples", "3000", "--range-mm", "50",
                               "--range-deg", "15", "--seed", "7", "--out", model});
    EXPECT_EQ(again.status, 0) << "a model takes the place of a model";
    EXPECT_EQ(readText(model), text);
    files.file("truncated", text.substr(0, text.size() / 2));
    files.file("one-byte-less", text.substr(0, text.size() - 1));
    files.file("unsigned", text.substr(0, text.rfind('\n', text.size() - 2) + 1));
    std::string flipped = text;
    char& digit = flipped[text.find_first_of("123456789", text.size() / 2)];
    digit = digit == '9' ? '8' : static_cast<char>(digit + 1);
    files.file("flipped", flipped);
    files.file("longer", text + "surplus = 1\n");
    std::string second = text;
    second[text.find("format")] = 'F';
    files.file("headless", second);
    std::vector<BadCall> calls;
    for (const std::string name : {"truncated", "one-byte-less", "unsigned", "flipped", "longer", "headless"})
        calls.push_back({"forward @lengths.csv --method mpr3 --model @" + name, {"@" + name}});
    calls.push_back(
        {"forward @lengths.csv --method mpr2-nr --model @model", {"@model", "degree 3", "degree 2"}});
    calls.push_back({"forward @lengths.csv --model @model --platform @other.toml", {"@model", "platform"}});
    calls.push_back(
        {"run --port virtual --targets @poses.csv --log @log.csv --model @flipped", {"@flipped"}});
    expectCliRefused(files, calls);
}

TEST(BadOptions, OfTrain) {
    const Files files;
    const std::string train = "train --samples 500 --degree 1 ";
    expectCliRefused(files, {
                                {"train", {"--out"}},
                                {train + "--out", {"out"}},
                                {train + "--out @missing/model", {"@missing/model"}},
                                {train + "--out @plain/model", {"@plain/model"}},
                                {train + "--out @directory", {"@directory"}},
                                {train + "--out @plain", {"@plain", "not a regression model"}},
                                {train + "--out @empty.csv", {"@empty.csv", "not a regression model"}},
                                {train + "--out /dev/null", {"/dev/null", "not a regression model"}},
                                {train + "--out @m --range-deg 90.5", {"--range-deg", "90.5"}},
                                {"train --out @m --degree 0", {"--degree", "0"}},
                                {"train --out @m --degree 5", {"--degree", "5"}},
                                {"train --out @m --degree three", {"--degree", "three"}},
                                {"train --out @m --samples 0", {"--samples", "0"}},
                                {"train --out @m --samples -5", {"--samples", "-5"}},
                                {"train --out @m --samples 1e5", {"--samples", "1e5"}},
                                {"train --out @m --degree 3 --samples 20", {"samples"}},
                                {train + "--out @m --range-mm -1", {"--range-mm", "-1"}},
                                {train + "--out @m --range-mm x", {"--range-mm", "x"}},
                                {train + "--out @m --range-mm inf", {"--range-mm", "inf"}},
                                {train + "--out @m --range-deg 0", {"--range-deg", "0"}},
                                {train + "--out @m --seed -1", {"--seed", "-1"}},
                                {train + "--out @m --seed x", {"--seed", "x"}},
                            });
}

TEST(BadOptions, OfSimulate) {
    const Files files;
    const std::string simulate = "simulate --protocol line ";
    expectCliRefused(files, {
                                {"simulate", {"--protocol"}},
                                {"simulate --protocol modbus", {"--protocol", "modbus"}},
                                {"simulate --protocol smoke", {"--protocol", "smoke"}},
                                {simulate + "--period-ms 0", {"--period-ms", "0"}},
                                {simulate + "--period-ms 1001", {"--period-ms", "1001"}},
                                {simulate + "--period-ms ten", {"--period-ms", "ten"}},
                                {simulate + "--link @missing/port", {"@missing/port"}},
                                {simulate + "--link @plain", {"@plain"}},
                                {simulate + "--link @directory", {"@directory"}},
                                {simulate + "--faults crc=2", {"crc=2"}},
                                {simulate + "--faults crc", {"crc"}},
                                {simulate + "--faults crc=x", {"crc=x"}},
                                {simulate + "--faults fire=0.1", {"fire"}},
                                {simulate + "--faults crc=0.1,crc=0.2", {"crc"}},
                                {simulate + "--faults silence=10", {"silence=10"}},
                                {simulate + "--faults noise=-1", {"noise=-1"}},
                                {simulate + "--faults ''", {"faults"}},
                                {simulate + "--link ''", {"--link"}},
                                {simulate + "--resolution-mm 0", {"--resolution-mm"}},
                            });
}

TEST(BadOptions, OfExperiment) {
    const Files files;
    const std::string good = "experiment closed-loop --out @out ";
    expectCliRefused(files, {{"experiment --out @out", {"experiment"}},
                             {"experiment open-loop --out @out", {"open-loop", "closed-loop"}},
                             {"experiment closed-loop", {"--out"}},
                             {"experiment closed-loop --out @plain", {"@plain"}},
                             {good + "--moves 0", {"--moves", "0"}},
                             {good + "--time-constants-ms 1,2", {"--time-constants-ms", "1,2"}},
                             {good + "--time-constants-ms 1,2,3,4,5,x", {"--time-constants-ms", "x"}},
                             {good + "--time-constants-ms 0", {"--time-constants-ms", "0"}},
                             {good + "--push-mm none", {"--push-mm", "none"}},
                             {good + "--platform @plain", {"@plain"}}});
}

TEST(BadOptions, OfRunAndNothingIsSentOrDamaged) {
    const Files files;
    const Scratch elsewhere;
    const std::string port = elsewhere.path("port");
    ForeignController controller(port, {}, {});
    files.file("kept.csv", "measured for weeks\n");
    files.file("beside.toml", "kept = true\n");
    const std::string far = "x_mm,y_mm,z_mm,alpha_deg,beta_deg,gamma_deg\n0,0,0,0,0,0\n0,0,90,0,0,0\n";
    files.file("far.csv", far);
    files.file("words.csv", kPoses + "1,2,three,0,0,0\n");
    files.file("nan.csv", kPoses + "1,2,nan,0,0,0\n");
    files.file("short.csv", kPoses + "1,2,3\n1,2,3,0,0,0\n");
    files.file("none.csv", kPoses.substr(0, kPoses.find('\n') + 1));
    const auto run = [&](const std::string& targets, const std::string& log, const std::string& more = {}) {
        return "run --port " + port + " --targets " + targets + " --log " + log + " " + more;
    };
    const std::string good = run("@poses.csv", "@log.csv");
    const std::string anyPort = "run --targets @poses.csv --log @log.csv --port ";
    expectCliRefused(files,
                     {
                         {"run --targets @poses.csv --log @log.csv", {"--port"}},
                         {"run --port virtual --log @log.csv", {"--targets"}},
                         {"run --port virtual --targets @poses.csv", {"--log"}},
                         {anyPort + "/dev/ttyNOWHERE", {"/dev/ttyNOWHERE", "no such"}},
                         {anyPort + "@plain", {"@plain"}},
                         {anyPort + "/dev/null", {"/dev/null", "not a serial port"}},
                         {anyPort + "@directory", {"@directory"}},
                         {good + "--baud 0", {"--baud", "0"}},
                         {good + "--baud fast", {"--baud", "fast"}},
                         {good + "--baud -9600", {"--baud", "-9600"}},
                         {good + "--mode fast", {"--mode", "fast"}},
                         {good + "--sweep z,5,0.1,1,10", {"--sweep", "--targets"}},
                         {good + "--speed 0", {"--speed", "0"}},
                         {good + "--speed 101", {"--speed", "101"}},
                         {good + "--envelope-mm -5", {"--envelope-mm", "-5"}},
                         {good + "--envelope-deg much", {"--envelope-deg", "much"}},
                         {good + "--mode magic", {"--mode", "magic"}},
                         {good + "--method magic", {"--method", "magic"}},
                         {run("@missing.csv", "@log.csv"), {"@missing.csv"}},
                         {run("@directory", "@log.csv"), {"@directory"}},
                         {run("@empty.csv", "@log.csv"), {"@empty.csv", "empty"}},
                         {run("@none.csv", "@log.csv"), {"@none.csv"}},
                         {run("@lengths.csv", "@log.csv"), {"@lengths.csv:1:", "x_mm"}},
                         {run("@words.csv", "@log.csv"), {"@words.csv:3:", "three"}},
                         {run("@nan.csv", "@log.csv"), {"@nan.csv:3:", "nan"}},
                         {run("@short.csv", "@log.csv"), {"@short.csv:3:"}},
                         {run("@far.csv", "@log.csv"), {"@far.csv", "above max_mm", "350"}},
                         {run("@poses.csv", "@kept.csv"), {"@kept.csv", "exists"}},
                         {run("@poses.csv", "@poses.csv"), {"@poses.csv", "exists"}},
                         {run("@poses.csv", "@beside.csv"), {"@beside.toml", "exists"}},
                         {run("@poses.csv", "@missing/log.csv"), {"@missing/log.csv"}},
                         {run("@poses.csv", "@plain/log.csv"), {"@plain/log.csv"}},
                         {run("@poses.csv", "@directory"), {"@directory"}},
                         {run("@poses.csv", "@log.csv", "--report @plain/report"), {"@plain/report"}},
                         {run("@poses.csv", "@log.csv", "--report @log.csv"), {"--report", "@log.csv"}},
                         {run("@poses.csv", "@log.csv", "--report @log.toml"), {"--report", "@log.toml"}},
                         {run("@poses.csv", "@kept.csv", "--report @new/deep"), {"@kept.csv", "exists"}},
                         {anyPort + "/dev/ttyNOWHERE --report @new/deep", {"/dev/ttyNOWHERE"}},
                         {run("@poses.csv", "-"), {"--log", "'-'"}},
                         {good + "--log-part-mb 0", {"--log-part-mb", "0"}},
                         {good + "--log-part-mb 0.5", {"--log-part-mb", "0.5"}},
                     });
    const std::vector<std::string> payloads = controller.payloads();
    EXPECT_TRUE(std::all_of(payloads.begin(), payloads.end(), [](const auto& p) { return p == "HELLO,1"; }))
        << "nothing but questions before all is known to be good";
}

} // namespace
} // namespace hexapose::apptest
