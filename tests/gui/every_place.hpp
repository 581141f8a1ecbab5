#pragma once

#include <functional>
#include <string>

#include "driven_window.hpp"

class QDialog;
class QMenu;

namespace talus {

/// Leads a window to every page, form, panel, dialog and menu that a user comes to, each with something in it.
class EveryPlace : public DrivenWindow {
 protected:
  /// Told of each place once it is there: a name that suits a file.
  using Look = std::function<void(const std::string& place)>;
  void visitAll(const QSize& size, Look look);

  /// The window with all that lies over it.
  QPixmap picture() const;
  /// Holds a small picture of the place, without what hangs on the machine, to its baseline.
  void expectAsItWas(const std::string& place);

 private:
  void begin();
  void importGeometry();
  void setUp();
  void orient();
  void cutAndMesh();
  void act();
  void everyForm();
  void showTroubles();
  void solve();
  void takeSteps(std::size_t count);
  void measureResults();
  void compareResults();
  void studyAndVerify();
  void openMenus();

  /// A project that is as it should be.
  void open(const std::filesystem::path& file);
  void look(const std::string& place);
  /// Goes to a page, with something selected.
  void look(const std::string& place, WorkflowPage page, const Item& item = {});
  /// Does a command by the words that it has in the menus, and looks at what comes up.
  void look(const std::string& place, const char* words);
  void lookAt(const std::string& place, QMenu& menu, const QPoint& at);
  void command(const char* words);
  /// Closes everything but the window.
  void closeAll();
  /// Looks at the question that `action` asks, and takes it back.
  void lookAtQuestion(const std::string& place, const std::function<void()>& action);
  template <class Widget>
  Widget& shown() {
    for (auto* one : window->findChildren<Widget*>())
      if (one->isVisible()) return *one;
    throw std::runtime_error(std::string("nothing is shown of ") + Widget::staticMetaObject.className());
  }
  /// As long as the solver says that it works, whatever the machine takes for it; then for what the window makes of it.
  template <class Condition>
  void waitForRun(Condition condition) {
    while (session->run.job().isBusy() && !condition())
      wait([&] { return !session->run.job().isBusy() || condition(); });
    EXPECT_TRUE(wait(condition));
  }
  void pick(int block, const Vec3& point, const Vec3& normal = {0, 0, 1});

  Look look_;
  std::filesystem::path slope_;
};

}  // namespace talus
