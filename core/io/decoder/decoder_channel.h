#pragma once
// Internal: messages between the reading process and its DICOM decoder, over a socket. JSON as CBOR behind a
// length of four bytes; texts are any bytes.

#include <nlohmann/json.hpp>

#include "core/io/formats/volume_source.h"

namespace handlebody {

using Message = nlohmann::json;

//! What the child finds open.
inline constexpr int kDecoderSocket = 3, kDecoderMemory = 4;

//! False if the other side is gone.
bool sendMessage(int socket, const Message& message);
//! One whole message, waiting as long as it takes between its bytes. Nothing if the other side is gone or
//! does not keep to the form.
std::optional<Message> receiveMessage(int socket);

Message findingToMessage(const Finding& finding);
//! With the values that the words of its kind have a place for; none where the kind is not known. Throws
//! Message::exception for what is not of the form.
Finding findingFromMessage(const Message& message);
Message requestToMessage(const OpenRequest& request);
OpenRequest requestFromMessage(const Message& message);
Message headerToMessage(const VolumeHeader& header);
//! Throws Message::exception for what is not of the form.
VolumeHeader headerFromMessage(const Message& message);

}  // namespace handlebody
