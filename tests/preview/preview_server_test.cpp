// SPDX-License-Identifier: Apache-2.0
// The preview over HTTP: its answers, refusals and robustness. Expected pictures are those that the program makes
// of the same frames.
#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <atomic>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/error.h"
#include "core/file_handle.h"
#include "preview/preview_fixture.h"
#include "preview/watched_scene.h"
#include "support/shell_run.h"

namespace poinsot::preview {
namespace {

/// Encodes every byte as %XX, which RFC 3986 allows.
std::string percentEncoded(const std::string& text) {
  std::string encoded;
  for (const unsigned char byte : text) encoded += fmt::format("%{:02X}", byte);
  return encoded;
}

using testing::HasSubstr;

TEST_F(Preview, ShowsTheSamePicturesAsTheStillCommand) {
  expectSamePicture(picture(30), "--time 1");
  expectSamePicture(picture(30, "&D=style.theme%3D%22dark%22"), "--time 1 -D style.theme=dark");
  expectSamePicture(picture(100000), "--time 1.9666666666666666");  // the last of 60
}

TEST_F(Preview, DescribesTheFilmAndThePhysics) {
  const json told = scene(-1);
  EXPECT_EQ(told["error"], "");
  EXPECT_EQ(told["film"]["frames"], 60);
  EXPECT_EQ(told["film"]["size"], json({320, 180}));
  EXPECT_EQ(told["film"]["notes"], json::array());
  EXPECT_EQ(told["film"]["physics"][0]["title"].get<std::string>().substr(0, 4), "Body");
  const json series = json::parse(get("series?name=omega_2&name=T")->body);
  EXPECT_EQ(series["series"].size(), 2u);
  EXPECT_EQ(series["series"][0]["values"].size(), series["times_s"].size());
  EXPECT_DOUBLE_EQ(series["series"][0]["values"][0], 3);
  EXPECT_NEAR(series["series"][1]["values"].back().get<double>(), (0.01 + 2 * 9 + 3 * 0.01) / 2, 1e-12);
}

TEST_F(Preview, ReportsNotesAboutProbableMistakes) {
  save("a.toml", kScene + std::string("[camera]\nazimuth = 2\n"));
  const json film = scene(1)["film"];
  ASSERT_EQ(film["notes"].size(), 1u);
  EXPECT_THAT(film["notes"][0].get<std::string>(),
              HasSubstr("a.toml:10:11: note: camera.azimuth: 2 is in radians"));
}

TEST_F(Preview, ListsTheTimeline) {
  EXPECT_EQ(scene(-1)["film"]["timeline"], json::array());
  save("a.toml", kScene + std::string("[[timeline]]\nat = 1.5\ncaption = 'Two'\n[[timeline]]\nat = 0.25\n"
                                      "caption = 'One <b>'\nspeed = 0.5\n"));
  EXPECT_EQ(scene(1)["film"]["timeline"], json({{{"at_s", 0.25}, {"moment", ""}, {"text", "“One <b>”; speed 0.5"}},
                                                {{"at_s", 1.5}, {"moment", ""}, {"text", "“Two”"}}}));
}

TEST_F(Preview, ShowsTheCommandForAFigure) {
  const std::string file = (folder_ / "a.toml").string();
  EXPECT_EQ(get("still/command?format=pdf&frame=45")->body,
            "poinsot still " + file + " --time 1.5 -o out/a_1500ms.pdf");
  EXPECT_EQ(get("still/command?format=tex&frame=100000&view=0&D=" + percentEncoded("style.theme=\"it's\""))->body,
            "poinsot still " + file +
                " --time 1.9666666666666666 -o out/a_1967ms.tex -D 'style.theme=\"it'\\''s\"' "
                "--view 1");
  EXPECT_EQ(get("still/command?format=png&frame=-3&D=--force")->body,
            "poinsot still " + file + " --time 0 -o out/a_0ms.png -D--force")
      << "no option of the program";
}

TEST_F(Preview, RejectsStillsThatItCannotMake) {
  for (const char* what : {"still", "still?format=png", "still?frame=1", "still?frame=x&format=png",
                           "still?frame=1&format=mp4", "still/command?frame=1", "still/command?format=pdf"})
    EXPECT_EQ(get(what)->status, 400) << what;
  const std::string token(32, '0');
  for (const char* what : {"/still?frame=1&format=png", "/still/command?frame=1&format=png"})
    EXPECT_EQ(client().Get("/" + token + what)->status, 403) << what;
  const auto foreign = client().Get(root_ + "still?frame=1&format=png", {{"Host", "evil.example"}});
  EXPECT_EQ(foreign->status, 403);
}

TEST_F(Preview, ShowsOneViewOfSeveral) {
  const std::string one = "[[view]]\ncamera.azimuth = \"40 deg\"\n",
                    other = "[[view]]\ntitle = \"Body\"\ncamera.frame = \"body\"\ncamera.elevation = \"8 deg\"\n",
                    plot = "[[plot]]\nquantities = [\"omega_2\"]\n";
  save("a.toml", kScene + one + other + plot);
  const json film = scene(1)["film"];
  EXPECT_EQ(film["panels"], 3);
  EXPECT_EQ(film["views"][1]["title"], "Body");
  EXPECT_NEAR(film["views"][1]["camera"]["elevation"].get<double>(), 8, 1e-12);
  EXPECT_EQ(film["ownViews"], true);
  const auto camera = [](const std::string& line) { return "&D=" + percentEncoded("view[1].camera." + line); };
  const std::string alone = picture(30, "&view=1"),
                    turned = picture(30, "&view=1" + camera("azimuth=\"-20 deg\"") +
                                             camera("elevation=\"30 deg\"") + camera("zoom=1.5"));
  const auto refused = get("picture?frame=0&width=320&height=180&view=2");
  EXPECT_EQ(refused->status, 422);
  EXPECT_THAT(refused->body, HasSubstr("--view 3: the scene has 2 views; give 1 to 2"));
  expectSamePicture(alone, "--time 1 --view 2");
  save("a.toml", kScene + other);  // the view alone
  expectSamePicture(alone, "--time 1");
  expectSamePicture(turned,
                    "--time 1 -D 'view[0].camera.azimuth=\"-20 deg\"' -D 'view[0].camera.elevation=\"30 deg\"' "
                    "-D 'view[0].camera.zoom=1.5'");
}

class PreviewOfASweep : public Preview {
 protected:
  PreviewOfASweep() : Preview({kRange}) {}
  static constexpr const char* kRange = "motion.omega_body=[0.1..0.5:4, 3, 0.1]";
};

TEST_F(PreviewOfASweep, ShowsAllCellsAndTurnsThemTogether) {
  const std::string range = std::string("-D '") + kRange + "' ";
  expectSamePicture(picture(30), range + "--time 1", "sweep");
  expectSamePicture(picture(30, "&D=camera.azimuth%3D%22-40%20deg%22"),
                    range + "--time 1 -D 'camera.azimuth=\"-40 deg\"'", "sweep");
  const json film = scene(-1)["film"];
  EXPECT_EQ(film["sweep"], true);
  EXPECT_EQ(film["panels"], 1) << "there is no view to choose";
  EXPECT_EQ(film["frames"], 60);
  EXPECT_DOUBLE_EQ(json::parse(get("series?name=omega_1")->body)["series"][0]["values"][0], 0.1);
}

TEST_F(PreviewOfASweep, ReportsMistakesInACell) {
  const int first = scene(-1)["version"];
  std::string looped = kScene;
  looped.replace(looped.find("duration"), 0, "loop = true\n");
  save("a.toml", looped);
  const json broken = scene(first);
  EXPECT_THAT(broken["error"], HasSubstr("sweep"));
  EXPECT_EQ(broken["film"]["frames"], 60) << "of the last good one";
}

TEST_F(Preview, ReloadsAChangedSceneFile) {
  const int first = scene(-1)["version"];
  std::thread editor([this] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    save("a.toml", std::string(kScene) + "[style]\nthem = \"dark\"\n");
  });
  const json broken = scene(first);  // waits for the edit
  editor.join();
  EXPECT_THAT(broken["error"],
              HasSubstr("a.toml:10:1: error: style.them: unknown key; did you mean style.theme?"));
  EXPECT_EQ(broken["film"]["frames"], 60) << "of the last good one";
  save("a.toml", std::string(kScene) + "[style]\ntheme = \"dark\"\n");
  EXPECT_EQ(scene(broken["version"])["error"], "");
  expectSamePicture(picture(30), "--time 1");
}

// A file that is saved while the preview is still starting counts as new, like a file saved later.
TEST_F(Preview, ReloadsASceneFileSavedDuringTheStart) {
  for (int i = 0; i < 20; ++i) {
    save("b.toml", kScene);
    const WatchedScene scene((folder_ / "b.toml").string(), {}, {});
    save("b.toml", std::string(kScene) + "[style]\ntheme = \"dark\"\n");
    EXPECT_EQ(scene.after(1, std::chrono::seconds(10)).number, 2);
  }
}

TEST_F(Preview, ReloadsChangedFilesThatTheSceneNames) {
  const std::string style = "[style]\nfile = \"own.toml\"\n";
  save("a.toml", kScene + style);
  json told = scene(1);
  EXPECT_THAT(told["error"], HasSubstr("own.toml"));
  save("own.toml", "[style]\ntheme = \"dark\"\n");  // appears; the scene's file stays untouched
  told = scene(told["version"]);
  EXPECT_EQ(told["error"], "");
  const std::string dark = picture(0);
  save("own.toml", "[style]\ntheme = \"light\"\n");
  EXPECT_EQ(scene(told["version"])["error"], "");
  EXPECT_TRUE(picture(0) != dark);
}

TEST_F(Preview, AnswersOnlyAtItsSecretAddress) {
  for (const std::string& path :
       {std::string("/"), std::string("/scene"), "/" + std::string(32, '0') + "/", root_.substr(0, 8) + "/",
        root_ + "../" + root_, std::string("/../../etc/passwd")})
    EXPECT_GE(client().Get(path)->status, 400) << path;
  EXPECT_EQ(client().Get("/" + std::string(32, '0') + "/scene")->status, 403);
  for (const char* path : {"../../../etc/passwd", "%2e%2e/%2e%2e/etc/passwd", "a.toml", "film/../../a.toml"})
    EXPECT_EQ(get(path)->status, 404) << path;
}

TEST_F(Preview, RejectsNamesOfOtherHosts) {
  const auto as = [&](const std::string& host) { return client().Get(root_ + "film", {{"Host", host}})->status; };
  for (const char* host : {"localhost", "127.0.0.1:1", "localhost:9999", "[::1]:80"})
    EXPECT_EQ(as(host), 200) << host;
  for (const char* host :
       {"evil.example", "127.0.0.1.evil.example", "localhost.evil.example:80", "[::1].evil", "[::1", ""})
    EXPECT_EQ(as(host), 403) << host;
}

TEST_F(Preview, RejectsRequestsThatItCannotDraw) {
  for (const char* what : {"picture", "picture?frame=x&width=9&height=9",
                           "picture?frame=1&width=100000&height=100000", "picture?frame=1&width=320"})
    EXPECT_EQ(get(what)->status, 400) << what;
  const auto bad = get("picture?frame=1&width=320&height=180&D=camera.fovv%3D3");
  EXPECT_EQ(bad->status, 422);
  EXPECT_THAT(bad->body, HasSubstr("did you mean camera.fov?"));
  EXPECT_EQ(get("series?name=nothing")->status, 422);
  EXPECT_EQ(get("picture?frame=-5&width=320&height=180")->status, 200) << "the first";
}

TEST_F(Preview, SurvivesManyRequestsAndClientsThatLeave) {
  const std::string expected = picture(7);
  std::vector<std::thread> all;
  std::atomic<int> good = 0;
  for (int i = 0; i < 200; ++i)
    all.emplace_back([&, i] {
      if (i % 4 == 0) {  // leaves in the middle of a picture
        client().Get(root_ + "picture?width=320&height=180&frame=7",
                     [](const char*, std::size_t) { return false; });
        ++good;
      } else {
        good += picture(7) == expected;
      }
    });
  for (std::thread& one : all) one.join();
  EXPECT_EQ(good, 200);
  EXPECT_EQ(picture(7), expected);
}

// `cp --preserve` and some editors over a network write a file in place, and keep its old time.
TEST_F(Preview, DetectsAChangeThatKeepsSizeAndTime) {
  const int first = scene(-1)["version"];
  const auto file = folder_ / "a.toml";
  std::string text = kScene;
  text.replace(text.find("0.1, 3"), 6, "0.1, 5");
  const auto time = std::filesystem::last_write_time(file);
  const core::FileHandle written(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  ASSERT_EQ(::pwrite(written.get(), text.data(), text.size(), 0), static_cast<ssize_t>(text.size()));
  std::filesystem::last_write_time(file, time);
  EXPECT_GT(scene(first)["version"].get<int>(), first);
  EXPECT_DOUBLE_EQ(json::parse(get("series?name=omega_2")->body)["series"][0]["values"][0], 5);
}

// Runs the command. It prints how to reach it by ssh, with this machine's address as the client sees it. It also
// prints mistakes in the scene, and starts all the same.
TEST(PreviewCommand, PrintsSshAddressAndMistakes) {
  const ScratchFolder folder;
  folder.put("a.toml", kScene);
  const auto said = [&](const std::vector<std::string>& environment) {
    const std::string untilItSays = "for i in $(seq 400); do grep -q Ctrl-C out && break; sleep 0.05; done\n";
    return runShell(
               folder.path(),
               POINSOT_PROGRAM " preview a.toml > out 2>&1 &\n" + untilItSays + "kill -TERM $!; wait $!; cat out",
               environment)
        .out;
  };
  EXPECT_THAT(said({"USER=anna", "SSH_CONNECTION=192.0.2.1 5 192.0.2.7 22"}),
              testing::ContainsRegex("\n  ssh -L ([0-9]+):127\\.0\\.0\\.1:[0-9]+ anna@192\\.0\\.2\\.7\n"));
  EXPECT_THAT(said({"SSH_CONNECTION="}), HasSubstr(" THIS_MACHINE\n"));
  folder.put("a.toml", std::string("[boddy]\n") + kScene);
  const std::string wrong = said({});
  EXPECT_THAT(wrong, HasSubstr("a.toml:1:2: error: boddy: unknown "));
  EXPECT_THAT(wrong,
              HasSubstr("poinsot: the page shows these errors too, and the scene as soon as they are fixed\n"));
}

/// Runs `poinsot preview` as a process, because only the program can render films.
class PreviewProcess {
 public:
  PreviewProcess(const std::filesystem::path& folder, const std::string& words) {
    const std::string command =
        "cd '" + folder.string() + "' && { echo $$; exec " POINSOT_PROGRAM " preview " + words + " 2>/dev/null; }";
    pipe_ = popen(command.c_str(), "r");
    process_ = std::stoi(line());
    const std::string address = line();  // http://127.0.0.1:PORT/TOKEN/
    const auto slash = address.find('/', 8), colon = address.rfind(':', slash);
    root_ = address.substr(slash);
    port_ = std::stoi(address.substr(colon + 1));
    client_ = std::make_unique<httplib::Client>("127.0.0.1", port_);
  }
  ~PreviewProcess() {
    kill(process_, SIGTERM);
    pclose(pipe_);
  }
  PreviewProcess(const PreviewProcess&) = delete;

  /// Renders the film of the page and returns its last state.
  /// @param words  overrides for -D
  json film(const std::vector<std::string>& words, const std::string& view = "") {
    std::string asked = view.empty() ? "" : "view=" + view;
    for (const std::string& word : words) asked += "&D=" + percentEncoded(word);
    json state = json::parse(client_->Post(root_ + "film?" + asked)->body);
    while (state["stage"] == "making") {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      state = json::parse(client_->Get(root_ + "film")->body);
    }
    return state;
  }

  httplib::Result get(const std::string& what) { return httplib::Client("127.0.0.1", port_).Get(root_ + what); }

 private:
  std::string line() {
    std::string text;
    for (int c = 0; (c = std::fgetc(pipe_)) != EOF && c != '\n';) text += static_cast<char>(c);
    return text;
  }

  FILE* pipe_ = nullptr;
  pid_t process_ = -1;
  int port_ = 0;
  std::string root_;
  std::unique_ptr<httplib::Client> client_;
};

class PreviewedFilm : public testing::Test {
 protected:
  void expectFilm(PreviewProcess& preview, const std::vector<std::string>& overrides, const std::string& view,
                  const std::vector<std::string>& told, const std::string& command,
                  const std::string& made) const {
    const json state = preview.film(overrides, view);
    EXPECT_EQ(state["stage"], "ready") << state["text"];
    EXPECT_EQ(state["changes"], json(told));
    std::string words = view.empty() ? "" : " --view " + std::to_string(std::stoi(view) + 1);
    for (const std::string& word : overrides) words += " -D '" + word + "'";
    const auto same = runShell(
        folder_.path(), POINSOT_PROGRAM " " + command + words + " --quiet -o own.mp4 && cmp own.mp4 " + made);
    EXPECT_EQ(same.exitCode, 0) << same.out;
  }

  const std::string scene_ =
      "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.1, 3, 0.1]\n[time]\nduration = 0.2\n"
      "[output]\nsize = [64, 36]\n[[view]]\n[[view]]\ncamera.frame = \"body\"\n";
  ScratchFolder folder_;
};

// Tries every control of the page that changes a picture. Expected: the film that `render` makes with the same
// words.
TEST_F(PreviewedFilm, ShowsTheSameAsThePreviewPage) {
  folder_.put("a.toml", scene_);
  PreviewProcess preview(folder_.path(), "a.toml -D style.text_size=1.1");
  const std::string render = "render a.toml -D style.text_size=1.1", film = "out/a.mp4";
  const std::string dark = "style.theme=\"dark\"", body = "camera.frame=\"body\"", size = "output.size=[48, 26]";
  expectFilm(preview, {}, "", {}, render, film);
  expectFilm(preview, {body, dark, "camera.azimuth=\"40 deg\"", size}, "",
             {body, dark, "camera.azimuth=\"40 deg\"", size}, render, film);
  const std::string turned = "view[1].camera.azimuth=\"40 deg\"";
  expectFilm(preview, {turned}, "1", {turned, "only view 2"}, render, film);
  EXPECT_EQ(runShell(folder_.path(), "cat a.toml").out, scene_) << "the file is not written";
  EXPECT_EQ(preview.film({"--force"})["stage"], "failed") << "no option of the program";
}

TEST_F(PreviewedFilm, AppliesChangesOfThePageToASweep) {
  folder_.put("a.toml", scene_);
  const std::string range = "a.toml -D 'motion.omega_body=[0.1..0.2:2, 3, 0]'", dark = "style.theme=\"dark\"";
  PreviewProcess preview(folder_.path(), range);
  expectFilm(preview, {dark}, "", {dark}, "sweep " + range, "out/a_sweep.mp4");
}

class PreviewedStill : public PreviewedFilm {
 protected:
  void expectStill(PreviewProcess& preview, const std::string& asked, const std::string& command,
                   const std::string& made, const std::string& name) const {
    const auto answer = preview.get("still?" + asked);
    ASSERT_EQ(answer->status, 200) << answer->body;
    EXPECT_EQ(answer->get_header_value("Content-Disposition"), "attachment; filename=\"" + name + "\"");
    folder_.put("saved", answer->body);
    const auto same = runShell(folder_.path(), POINSOT_PROGRAM " " + command + " --quiet && cmp saved " + made);
    EXPECT_EQ(same.exitCode, 0) << same.out;
  }
};

TEST_F(PreviewedStill, HasTheBytesOfTheStillCommand) {
  folder_.put("a b.toml", scene_);
  PreviewProcess preview(folder_.path(), "'a b.toml' -D style.text_size=1.1");
  const std::string still = "still 'a b.toml' -D style.text_size=1.1 --time 0.1 -o own/a_b_100ms";
  std::filesystem::create_directory(folder_ / "own");
  const std::string dark = "&D=" + percentEncoded("style.theme=\"dark\"");
  expectStill(preview, "frame=3&format=png", still + ".png", "own/a_b_100ms.png", "a_b_100ms.png");
  expectStill(preview, "frame=3&format=pdf" + dark, still + ".pdf -D style.theme=dark", "own/a_b_100ms.pdf",
              "a_b_100ms.pdf");
  expectStill(preview, "frame=3&format=svg&view=1", still + ".svg --view 2", "own/a_b_100ms.svg", "a_b_100ms.svg");
  expectStill(preview, "frame=3&format=tex", still + ".tex", "own/a_b_100ms.tex", "a_b_100ms.tex");
  expectStill(preview, "frame=3&format=tex-image", still + ".tex", "own/a_b_100ms-unlabelled.png",
              "a_b_100ms-unlabelled.png");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out")) << "the preview writes nothing by itself";
}

TEST_F(PreviewedStill, ReportsWhyItCannotBeMade) {
  folder_.put("a.toml", scene_);
  PreviewProcess preview(folder_.path(), "a.toml");
  const auto wrongKey = preview.get("still?frame=3&format=png&D=camera.fovv%3D3");
  EXPECT_EQ(wrongKey->status, 422);
  EXPECT_THAT(wrongKey->body, HasSubstr("did you mean camera.fov?"));
  EXPECT_EQ(preview.get("still?frame=3&format=png&D=--force")->status, 422) << "no option of the program";
  folder_.put("a.toml", "[boddy]\n" + scene_);
  const auto mistake = preview.get("still?frame=3&format=png");
  EXPECT_EQ(mistake->status, 422);
  EXPECT_THAT(mistake->body, HasSubstr("a.toml:1:2: error: boddy: unknown "));
}

// Two pictures at a time could need too much memory. The others are told to try again.
TEST_F(PreviewedStill, IsMadeOneAtATime) {
  folder_.put("a.toml", scene_);
  PreviewProcess preview(folder_.path(), "a.toml");
  std::atomic<int> made = 0, refused = 0;
  std::vector<std::thread> all;
  for (int i = 0; i < 8; ++i)
    all.emplace_back([&] {
      const int status = preview.get("still?frame=3&format=png")->status;
      made += status == 200;
      refused += status == 503;
    });
  for (std::thread& one : all) one.join();
  EXPECT_GE(made, 1);
  EXPECT_EQ(made + refused, 8);
  EXPECT_EQ(preview.get("still?frame=3&format=png")->status, 200);
}

TEST_F(Preview, RejectsAPortInUse) {
  const PreviewRequest request{.fileName = (folder_ / "a.toml").string(),
                               .overrides = {},
                               .allowance = {},
                               .backend = {},
                               .port = server_->port()};
  EXPECT_THROW(PreviewServer second(request), core::Error);
}

// A signal may come while the server is about to start.
TEST(PreviewServerTest, ExitsIfStoppedBeforeItStarts) {
  const ScratchFolder folder;
  folder.put("a.toml", kScene);
  for (int i = 0; i < 20; ++i) {
    PreviewServer server(PreviewRequest{.fileName = folder / "a.toml", .overrides = {}, .allowance = {}});
    std::thread stopping([&] { server.stop(); });
    server.run();
    stopping.join();
  }
}

}  // namespace
}  // namespace poinsot::preview
