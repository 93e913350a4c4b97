// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/own_instrument.hpp"

namespace swage::console {

OwnInstrument::OwnInstrument(const WindowPages* pages, Settings& settings) : pages_(pages), settings_(settings) {
  RunPage* run = pages->run();
  pages->setup()->set_devices(held_devices(run->catalogue()));
  connect(run->setup(), &SetupPanel::person_chosen, this, &OwnInstrument::take);
  connect(pages->setup(), &SetupPage::binding_chosen, this, [this, run](const Binding& binding) {
    console::remember(binding, run->setup()->person(), settings_);
    run->set_binding(binding);
  });
  take();
}

void OwnInstrument::take() {
  const QString person = pages_->run()->setup()->person();
  const Binding binding = read_binding(settings_, person);
  pages_->setup()->show_binding(binding, person);
  pages_->run()->set_binding(binding);
}

}  // namespace swage::console
