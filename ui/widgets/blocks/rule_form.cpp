#include "widgets/blocks/rule_form.hpp"

#include <Eigen/Geometry>
#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <array>
#include <memory>

#include "widgets/kit/model_words.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

enum Question {
  volume_below,
  volume_above,
  thinner,
  below_plane,
  above_plane,
  on_joint,
  on_free_face,
  removable,
  of_body,
  of_material,
  of_solid,
  named
};

constexpr int title_width = 104;

}  // namespace

RuleForm::RuleForm(Session& session) : session_(session) {
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 6);
  question_ = makeCombo({tr("volume below"), tr("volume above"), tr("thinner than"), tr("below a plane"),
                         tr("above a plane"), tr("touches a joint"), tr("on the free surface"), tr("can leave"),
                         tr("body"), tr("material"), tr("from a solid"), tr("name like")},
                        tr("What is asked of the blocks"));
  question_->setObjectName(QStringLiteral("question"));
  column->addWidget(question_);
  connect(question_, &QComboBox::activated, this, &RuleForm::showQuestion);
  connect(question_, &QComboBox::currentIndexChanged, this, &RuleForm::showQuestion);
  showQuestion();
}

void RuleForm::refresh() { showQuestion(); }

void RuleForm::addRow(const QString& title, QWidget* field) {
  auto* label = makeLabel(title, "muted");
  label->setFixedWidth(title_width);
  field->setAccessibleName(title);
  rows_->addRow(label, field);
}

void RuleForm::showQuestion() {
  delete answers_;
  answers_ = new QWidget;
  rows_ = new QFormLayout(answers_);
  setMargins(rows_, 0, 6);
  layout()->addWidget(answers_);
  rule_ = {};
  const Project& built = session_.project.builtFrom();
  switch (static_cast<Question>(question_->currentIndex())) {
    case volume_below:
    case volume_above: {
      const Side side = question_->currentIndex() == volume_below ? Side::below : Side::above;
      askNumber(tr("Volume"), QStringLiteral("m³"), [side](double value) { return ByVolume{side, value}; });
      break;
    }
    case thinner:
      askNumber(tr("Thickness"), QStringLiteral("m"), [](double value) { return ByThickness{value}; });
      break;
    case below_plane:
      askPlane(Side::below);
      break;
    case above_plane:
      askPlane(Side::above);
      break;
    case on_joint:
      askWhich(tr("Joint"), built.joints, [](int joint) { return ByJoint{joint}; });
      break;
    case on_free_face:
      rule_ = [] { return ByFreeFace{}; };
      break;
    case removable:
      askWay();
      break;
    case of_body:
      askBody();
      break;
    case of_material:
      askWhich(tr("Material"), built.materials, [](int material) { return ByMaterial{material}; });
      break;
    case of_solid:
      askWhich(tr("Solid"), built.solids, [](int solid) { return BySolid{solid}; });
      break;
    case named:
      askName();
      break;
  }
  emit changed();
}

void RuleForm::askNumber(const QString& title, const QString& unit, std::function<BlockRule(double)> make) {
  auto* field = new NumberField(std::nullopt, {unit, unit});
  field->setObjectName(QStringLiteral("number"));
  field->setPlaceholderText(unit);
  addRow(title, field);
  const auto value = std::make_shared<std::optional<double>>();
  rule_ = [value, make] { return *value ? std::optional(make(**value)) : std::nullopt; };
  connect(field, &NumberField::committed, this, [this, value](double number) {
    *value = number;
    emit changed();
  });
  field->setFocus();
}

void RuleForm::askPlane(Side side) {
  auto* height = new NumberField(std::nullopt, {QStringLiteral("m"), QStringLiteral("m")});
  height->setObjectName(QStringLiteral("number"));
  addRow(tr("z ="), height);
  auto* pick = makeButton(picked_ ? tr("Through the three places picked") : tr("Pick three places in the view"));
  pick->setObjectName(QStringLiteral("pick"));
  pick->setAutoDefault(false);
  addRow(tr("or"), pick);
  const auto plane = std::make_shared<std::optional<ByPlane>>(picked_);
  rule_ = [plane, side]() -> std::optional<BlockRule> {
    if (!*plane) return std::nullopt;
    ByPlane one = **plane;
    one.side = side;
    return one;
  };
  connect(height, &NumberField::committed, this, [this, plane](double z) {
    *plane = ByPlane{.through = Vec3(0, 0, z)};
    emit changed();
  });
  connect(pick, &QPushButton::clicked, this, &RuleForm::pickPlane);
}

void RuleForm::pickPlane() {
  session_.picking.ask(tr("Click three places that the plane goes through"), 3,
                       [this](const std::vector<PickedPlace>& places) {
                         Vec3 normal = (places[1].point - places[0].point).cross(places[2].point - places[0].point);
                         if (normal.isZero(0)) return;  // in one line: there is no plane
                         if (normal.z() < 0) normal = -normal;
                         picked_ = ByPlane{.through = places[0].point, .normal = normal.normalized()};
                         showQuestion();
                       });
}

void RuleForm::askWay() {
  constexpr std::array ways{Leaving::stable, Leaving::falls, Leaving::slides_on_one, Leaving::slides_on_two};
  QStringList words{tr("in any way")};
  for (const Leaving way : ways) words << text(to_string(way));
  auto* way = makeCombo(words, tr("How"));
  way->setObjectName(QStringLiteral("way"));
  addRow(tr("How"), way);
  auto* factor = new NumberField(std::nullopt, {{}, {}});
  factor->allowNone(tr("whatever it is"));
  factor->setObjectName(QStringLiteral("number"));
  addRow(tr("F below"), factor);
  const auto rule = std::make_shared<ByRemovability>();
  rule_ = [rule] { return *rule; };
  connect(way, &QComboBox::currentIndexChanged, this, [this, rule, ways](int index) {
    rule->mode = index > 0 ? std::optional(ways[static_cast<std::size_t>(index - 1)]) : std::nullopt;
    emit changed();
  });
  connect(factor, &NumberField::committed, this, [this, rule](double value) {
    rule->factor_below = value;
    emit changed();
  });
  connect(factor, &NumberField::cleared, this, [this, rule] {
    rule->factor_below.reset();
    emit changed();
  });
}

void RuleForm::askBody() {
  constexpr std::array bodies{BodyKind::fixed, BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra};
  QStringList titles;
  for (const BodyKind body : bodies) titles << words::body(body);
  auto* box = makeCombo(titles, tr("Body"));
  box->setObjectName(QStringLiteral("which"));
  addRow(tr("Body"), box);
  rule_ = [box, bodies] { return ByBody{bodies[static_cast<std::size_t>(box->currentIndex())]}; };
  connect(box, &QComboBox::currentIndexChanged, this, &RuleForm::changed);
}

template <class Named>
void RuleForm::askWhich(const QString& title, const std::vector<Named>& things, std::function<BlockRule(int)> make) {
  QStringList names;
  for (const Named& thing : things) names << text(thing.name);
  auto* box = makeCombo(names, title);
  box->setObjectName(QStringLiteral("which"));
  addRow(title, box);
  rule_ = [box, make] { return box->currentIndex() < 0 ? std::nullopt : std::optional(make(box->currentIndex())); };
  connect(box, &QComboBox::currentIndexChanged, this, &RuleForm::changed);
}

void RuleForm::askName() {
  auto* name = new QLineEdit;
  name->setObjectName(QStringLiteral("name"));
  name->setPlaceholderText(QStringLiteral("roof *"));
  name->setToolTip(tr("* stands for any letters, ? for one; without these the letters are looked for in the name"));
  addRow(tr("Name"), name);
  rule_ = [name]() -> std::optional<BlockRule> {
    if (name->text().trimmed().isEmpty()) return std::nullopt;
    return ByName{name->text().trimmed().toStdString()};
  };
  connect(name, &QLineEdit::textChanged, this, &RuleForm::changed);
  name->setFocus();
}

}  // namespace talus
