// Objects from files in the Document's list.

#include <QFile>
#include <algorithm>

#include "core/cancellation.h"
#include "ui/model/document_private.h"
#include "ui/model/error_sentence.h"
#include "ui/model/object_labels.h"
#include "ui/model/opened_objects.h"

namespace handlebody::ui {

void Document::openObjects(const ObjectsToOpen& asked) {
  if (!hasVolume()) return;
  if (const QString fault = d_->addFault(); !fault.isEmpty()) return Q_EMIT openingObjectsFailed(fault);
  cancelOpeningObjects();
  const StopFlag flag = d_->openingObjects.begin();
  Q_EMIT openingObjects(asked.path);
  d_->files.post([this, asked, grid = volume().grid, stop = flag, number = d_->openingObjects.number(),
                  known = d_->hash] {
    auto opened = std::make_shared<std::vector<OpenedObject>>();
    QString failed;
    try {
      const CancelScope scope(*stop);
      *opened = readObjects(asked, grid);
    } catch (const Cancelled&) {
    } catch (...) {
      failed = errorSentence();
    }
    QMetaObject::invokeMethod(
        this,
        [this, asked, opened, failed, stop, number, known] {
          if (number != d_->openingObjects.number()) return;  // others are being opened in their place
          if (*stop || known != d_->hash)                     // they were meant for what was open
            Q_EMIT openingObjectsCancelled();
          else if (const QString fault = failed.isEmpty() ? d_->addFault() : failed; !fault.isEmpty())
            Q_EMIT openingObjectsFailed(fault);
          else
            d_->addOpened(asked, *opened);
        },
        Qt::QueuedConnection);
  });
}

void Document::cancelOpeningObjects() { d_->openingObjects.cancel(); }

void Document::Private::addOpened(const ObjectsToOpen& asked, const std::vector<OpenedObject>& opened) {
  ObjectList after = objects.list();
  auto place = after.entries.end();
  if (asked.as == OpenAs::done)
    place = std::find_if(after.entries.begin(), after.entries.end(), [](const ObjectList::Entry& entry) {
      return !entry.object->growth().exists() && !entry.object->isBusy();
    });
  std::vector<ObjectLabel> labels = objects.labels();
  std::vector<ObjectList::Entry> fresh;
  QStringList names;
  qint64 shared = 0;
  for (auto [session, hasLook] : opened) {
    ObjectLabel label = labelFor(session.label, labels);
    if (hasLook) {
      label.colour = session.label.colour;
      label.term = session.label.term;
    }
    label.source = session.label.source;
    session.label = label;
    labels.push_back(session.label);
    names << QString::fromStdString(session.label.name);
    shared += static_cast<qint64>(session.constraints.start->shared);
    auto object = newObject();
    object->adopt(session);
    fresh.push_back({object, {session.label, true, asked.as == OpenAs::done}});
  }
  after.entries.insert(place, fresh.begin(), fresh.end());
  if (asked.as == OpenAs::start) after.active = fresh.front().object;
  pushList(fresh.size() == 1 ? tr("Open object") : tr("Open objects"), std::move(after));
  begun.clear();
  withoutSurface.clear();
  for (const ObjectList::Entry& entry : fresh) begun.push_back(entry.object);
  for (const ObjectList::Entry& entry : fresh) entry.object->begin();
  Q_EMIT q.objectsOpened(asked.path, names, shared);
}

//! That it meets another object, say, is known only when it is prepared. All sentences each time: a message
//! takes the place of the one before.
void Document::Private::tellIfWithoutSurface(const ObjectWork& object) {
  const auto isIt = [&](const std::weak_ptr<const ObjectWork>& o) { return o.lock().get() == &object; };
  const auto found = std::find_if(begun.begin(), begun.end(), isIt);
  if (found == begun.end() || object.isBusy()) return;
  begun.erase(found);
  const QString why = object.error();
  if (why.isEmpty() || withoutSurface.contains(why)) return;
  withoutSurface << why;
  Q_EMIT q.refused(withoutSurface.join(QLatin1Char(' ')));
}

}  // namespace handlebody::ui
