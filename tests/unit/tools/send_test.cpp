// SPDX-License-Identifier: Apache-2.0
//
// swage attempts send: against a record store of this test, which can be away, refuse, or answer that it has the statement already.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <mutex>
#include <thread>

#include "program.hpp"
#include "record/recorder.hpp"
#include "tools/sentences.hpp"

namespace swage::tools::test {
namespace {

using testing::HasSubstr;

/// Answers each request on a port of this machine.
class FakeLrs {
 public:
  FakeLrs() {
    listen_ = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof at;
    EXPECT_EQ(bind(listen_, reinterpret_cast<sockaddr*>(&at), size), 0);
    EXPECT_EQ(getsockname(listen_, reinterpret_cast<sockaddr*>(&at), &size), 0);
    port_ = ntohs(at.sin_port);
    EXPECT_EQ(listen(listen_, 8), 0);
    thread_ = std::thread([this] { serve(); });
  }
  ~FakeLrs() {
    over_ = true;
    shutdown(listen_, SHUT_RDWR);
    thread_.join();
    close(listen_);
  }
  std::string url() const { return "http://127.0.0.1:" + std::to_string(port_) + "/xapi"; }
  std::atomic<int> status{200};
  std::atomic<int> status_of_many{0};  // for more than one statement, where not 0
  std::vector<nlohmann::json> kept() {
    const std::lock_guard lock(mutex_);
    return kept_;
  }
  std::string head() {
    const std::lock_guard lock(mutex_);
    return head_;
  }

 private:
  void serve() {
    while (!over_) {
      const int to = accept(listen_, nullptr, nullptr);
      if (to < 0) return;
      answer(to);
      close(to);
    }
  }
  void answer(int to) {
    std::string all;
    char some[4096];
    std::size_t head = std::string::npos, length = 0;
    while (head == std::string::npos || all.size() < head + 4 + length) {
      const ssize_t n = recv(to, some, sizeof some, 0);
      if (n <= 0) return;
      all.append(some, static_cast<std::size_t>(n));
      head = all.find("\r\n\r\n");
      const std::size_t at = all.find("Content-Length: ");
      if (head != std::string::npos && at < head) length = std::stoul(all.substr(at + 16));
    }
    const nlohmann::json body = nlohmann::json::parse(all.substr(head + 4), nullptr, false);
    const int code = body.size() > 1 && status_of_many != 0 ? status_of_many.load() : status.load();
    {
      const std::lock_guard lock(mutex_);
      head_ = all.substr(0, head);
      if (code == 200)
        for (const auto& s : body) kept_.push_back(s);
    }
    const std::string said = "HTTP/1.1 " + std::to_string(code) + " x\r\nContent-Length: 2\r\nConnection: close\r\n\r\n[]";
    EXPECT_EQ(send(to, said.data(), said.size(), MSG_NOSIGNAL), static_cast<ssize_t>(said.size()));
  }
  int listen_ = -1;
  uint16_t port_ = 0;
  std::atomic<bool> over_{false};
  std::mutex mutex_;
  std::vector<nlohmann::json> kept_;
  std::string head_;
  std::thread thread_;
};

class Send : public Program {
 protected:
  std::string keep(const std::string& person) const {
    record::AttemptInfo info;
    info.person = person;
    info.lesson_id = "org.example.a";
    info.mode = "test";
    info.device = "mouse";
    info.devices = {"hand"};
    base::Problems problems;
    const auto recorder = record::Recorder::open(store(), info, problems);
    if (!recorder) return "";
    record::AttemptEnd end;
    end.outcome = judge::Outcome::kPassed;
    end.score = 91;
    end.simulated_s = 0.3;
    recorder->finish(end);
    return recorder->attempt_id();
  }
  Said send_to(const std::string& url, std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"attempts", "send", "--to", url, "--home", "https://school.example.org", "--store", store(), "--json",
                                      "--receipts", path("receipts.txt")};
    words.insert(words.end(), more.begin(), more.end());
    return swage(words);
  }
};

TEST_F(Send, EachAttemptArrivesOnceAndWaitsWhileNobodyAnswers) {
  keep("Ada");
  keep("Bea");
  const Said away = send_to("http://127.0.0.1:9/xapi");
  EXPECT_EQ(away.code, 1);
  EXPECT_EQ(away.json()["waiting"], 2);
  EXPECT_THAT(away.err, HasSubstr(say::kNoAnswer.words(0)));
  FakeLrs lrs;
  lrs.status = 503;
  EXPECT_EQ(send_to(lrs.url()).json()["waiting"], 2);
  lrs.status = 200;
  const Said first = send_to(lrs.url());
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(first.json()["sent"], 2);
  EXPECT_THAT(lrs.head(), testing::StartsWith("POST /xapi/statements HTTP"));
  EXPECT_THAT(lrs.head(), HasSubstr("X-Experience-API-Version: 1.0.3"));
  const std::string id = keep("Ada");
  EXPECT_EQ(send_to(lrs.url()).json()["sent"], 1);
  EXPECT_EQ(send_to(lrs.url()).json()["sent"], 0);
  const auto kept = lrs.kept();
  ASSERT_EQ(kept.size(), 3u);
  EXPECT_EQ(kept[2]["context"]["extensions"]["https://school.example.org/x/attempt"], id);
  // another record store has not got them
  FakeLrs other;
  EXPECT_EQ(send_to(other.url()).json()["sent"], 3);
}

TEST_F(Send, OneStatementThatIsRefusedHoldsNobodyElseBack) {
  keep("Ada");
  keep("Bea");
  FakeLrs lrs;
  lrs.status_of_many = 400;
  EXPECT_EQ(send_to(lrs.url()).json()["sent"], 2) << "one by one";
  keep("Cy");
  lrs.status = 400;
  const Said refused = send_to(lrs.url());
  EXPECT_EQ(refused.code, 1);
  EXPECT_EQ(refused.json()["refused"], 1);
  EXPECT_THAT(refused.err, HasSubstr(say::kAnswers.words(0) + "400"));
  lrs.status = 409;  // it is there, with other words: what was sent before it was voided
  EXPECT_EQ(send_to(lrs.url()).code, 0);
  EXPECT_EQ(send_to(lrs.url()).json()["sent"], 0);
}

TEST_F(Send, TheLoginGoesToThatAddressAloneAndNothingUnencryptedLeavesTheMachine) {
  keep("Ada");
  write("login.txt", "mei:secret\n");
  FakeLrs lrs;
  lrs.status = 401;
  EXPECT_EQ(send_to(lrs.url()).json()["waiting"], 1);
  lrs.status = 200;
  EXPECT_EQ(send_to(lrs.url(), {"--login", path("login.txt")}).code, 0);
  EXPECT_THAT(lrs.head(), HasSubstr("Authorization: Basic bWVpOnNlY3JldA=="));
  for (const char* wrong : {"http://lrs.example.org/xapi", "http://127.0.0.1.example.org/xapi", "ftp://x", "https://u:p@lrs.example.org"})
    EXPECT_EQ(send_to(wrong).code, 2) << wrong;
  EXPECT_EQ(send_to(lrs.url(), {"--login", path("none.txt")}).code, 2);
}

}  // namespace
}  // namespace swage::tools::test
