#include "ui/shell/WorkInBackground.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace asperity {
namespace {

class WorkInBackgroundTest : public ::testing::Test {
protected:
    WorkInBackgroundTest() {
        QObject::connect(&works, &WorkInBackground::named, &works,
                         [this](const QString& words) { named = words.toStdString(); });
        QObject::connect(&works, &WorkInBackground::progressed, &works,
                         [this](double share) { fraction = share; });
    }
    int begin(const std::string& name) {
        const int ticket = works.ticket();
        works.enter(ticket, [this, ticket, name] {
            canceled.push_back(name);
            works.leave(ticket);
        });
        return ticket;
    }
    int beginShown(const std::string& name) {
        const int ticket = begin(name);
        works.show(ticket, QString::fromStdString(name));
        return ticket;
    }

    WorkInBackground works{nullptr};
    std::string named = "nothing was named";
    double fraction = -1.0;
    std::vector<std::string> canceled;
};

TEST_F(WorkInBackgroundTest, TheLineGoesBackToTheWorkThatStillRuns) {
    const int film = beginShown("film");
    works.setFraction(film, 0.25);
    const int scene = beginShown("scene");
    EXPECT_EQ(named, "scene");
    EXPECT_EQ(fraction, 0.0);
    works.setFraction(film, 0.5);
    EXPECT_EQ(fraction, 0.0) << "that of another work";
    works.leave(scene);
    EXPECT_EQ(named, "film");
    EXPECT_EQ(fraction, 0.5);
    works.leave(film);
    EXPECT_EQ(named, "");
}

TEST_F(WorkInBackgroundTest, OneAtATimeIsCanceledTheNamedOneFirst) {
    beginShown("film");
    beginShown("scene");
    (void)begin("quick");
    using Names = std::vector<std::string>;
    works.cancel();
    EXPECT_EQ(canceled, (Names{"scene"}));
    works.cancel();
    EXPECT_EQ(canceled, (Names{"scene", "film"}));
    works.cancel();
    EXPECT_EQ(canceled, (Names{"scene", "film", "quick"}));
    works.cancel();
    EXPECT_EQ(canceled.size(), 3U);
}

TEST_F(WorkInBackgroundTest, WorkThatBeginsAgainIsTheLatest) {
    const int scene = beginShown("scene");
    beginShown("film");
    works.enter(scene, [this] { canceled.emplace_back("scene again"); });
    works.show(scene, QStringLiteral("scene again"));
    EXPECT_EQ(named, "scene again");
    works.cancel();
    EXPECT_EQ(canceled, std::vector<std::string>{"scene again"});
}

}  // namespace
}  // namespace asperity
