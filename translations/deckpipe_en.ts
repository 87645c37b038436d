<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Details</name>
    <message numerus="yes">
        <source>and %n earlier</source>
        <translation>
            <numerusform>and %n earlier</numerusform>
            <numerusform>and %n earlier</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>EventText</name>
    <message numerus="yes">
        <source>%1: %Ln frames lost</source>
        <translation>
            <numerusform>%1: %Ln frame lost</numerusform>
            <numerusform>%1: %Ln frames lost</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln frames are not on the bus yet and may still go out</source>
        <translation>
            <numerusform>%1: %Ln frame is not on the bus yet and may still go out</numerusform>
            <numerusform>%1: %Ln frames are not on the bus yet and may still go out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln CAN FD frames came and are not held</source>
        <translation>
            <numerusform>%1: %Ln CAN FD frame came and is not held</numerusform>
            <numerusform>%1: %Ln CAN FD frames came and are not held</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln frames came that are not classic CAN and are not held</source>
        <translation>
            <numerusform>%1: %Ln frame came that is not classic CAN and is not held</numerusform>
            <numerusform>%1: %Ln frames came that are not classic CAN and are not held</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No more error frames; there were %Ln</source>
        <translation>
            <numerusform>No more error frames; there was %Ln</numerusform>
            <numerusform>No more error frames; there were %Ln</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 (%Ln changes right before it are not listed)</source>
        <translation>
            <numerusform>%1 (%Ln change right before it is not listed)</numerusform>
            <numerusform>%1 (%Ln changes right before it are not listed)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln CAN XL frames came and are not held</source>
        <translation>
            <numerusform>%1: %Ln CAN XL frame came and is not held</numerusform>
            <numerusform>%1: %Ln CAN XL frames came and are not held</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln lines of the file that this log was saved from could not be read</source>
        <translation>
            <numerusform>%1: %Ln line of the file that this log was saved from could not be read</numerusform>
            <numerusform>%1: %Ln lines of the file that this log was saved from could not be read</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: the recorder lost frames at %Ln places, as it says</source>
        <translation>
            <numerusform>%1: the recorder lost frames at %Ln place, as it says</numerusform>
            <numerusform>%1: the recorder lost frames at %Ln places, as it says</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: the file that this log was saved from was not whole at %Ln places</source>
        <translation>
            <numerusform>%1: the file that this log was saved from was not whole at %Ln place</numerusform>
            <numerusform>%1: the file that this log was saved from was not whole at %Ln places</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln frames are missing here: the recording is damaged</source>
        <translation>
            <numerusform>%Ln frame is missing here: the recording is damaged</numerusform>
            <numerusform>%Ln frames are missing here: the recording is damaged</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>NoticeText</name>
    <message numerus="yes">
        <source>%Ln lines of this log could not be read and are left out: %1</source>
        <translation>
            <numerusform>%Ln line of this log could not be read and is left out: %1</numerusform>
            <numerusform>%Ln lines of this log could not be read and are left out: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Connected, but nothing heard for %Ln seconds. Check in this order: is the truck&apos;s CAN powered; is the bit rate right (J1939 250 kbit/s, gateway 125); 60 ohms between CAN-H and CAN-L; CAN-H and CAN-L not swapped.</source>
        <translation>
            <numerusform>Connected, but nothing heard for %Ln second. Check in this order: is the truck&apos;s CAN powered; is the bit rate right (J1939 250 kbit/s, gateway 125); 60 ohms between CAN-H and CAN-L; CAN-H and CAN-L not swapped.</numerusform>
            <numerusform>Connected, but nothing heard for %Ln seconds. Check in this order: is the truck&apos;s CAN powered; is the bit rate right (J1939 250 kbit/s, gateway 125); 60 ohms between CAN-H and CAN-L; CAN-H and CAN-L not swapped.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln times of this log are written with more than nine decimals: only their seconds are kept, so rates and ages are not to be trusted.</source>
        <translation>
            <numerusform>%Ln time of this log is written with more than nine decimals: only its seconds are kept, so rates and ages are not to be trusted.</numerusform>
            <numerusform>%Ln times of this log are written with more than nine decimals: only their seconds are kept, so rates and ages are not to be trusted.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln parts of this log are of a newer version of Deckpipe and were left out.</source>
        <translation>
            <numerusform>%Ln part of this log is of a newer version of Deckpipe and was left out.</numerusform>
            <numerusform>%Ln parts of this log are of a newer version of Deckpipe and were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The end of this recording is not whole: its last %Ln bytes could not be read.</source>
        <translation>
            <numerusform>The end of this recording is not whole: its last byte could not be read.</numerusform>
            <numerusform>The end of this recording is not whole: its last %Ln bytes could not be read.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At least %Ln frames are missing.</source>
        <translation>
            <numerusform>At least one frame is missing.</numerusform>
            <numerusform>At least %Ln frames are missing.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>This recording is damaged in %Ln places, the first at byte %1.</source>
        <translation>
            <numerusform>This recording is damaged in one place, at byte %1.</numerusform>
            <numerusform>This recording is damaged in %Ln places, the first at byte %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln bytes could not be read.</source>
        <translation>
            <numerusform>One byte could not be read.</numerusform>
            <numerusform>%Ln bytes could not be read.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Overview</name>
    <message numerus="yes">
        <source>%n fault(s)</source>
        <translation>
            <numerusform>%n fault</numerusform>
            <numerusform>%n faults</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n monitor(s): %1</source>
        <translation>
            <numerusform>%n monitor: %1</numerusform>
            <numerusform>%n monitors: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Row</name>
    <message numerus="yes">
        <source>%Ln frames on channels beyond the first %1: their devices are not listed</source>
        <translation>
            <numerusform>%Ln frame on channels beyond the first %1: their devices are not listed</numerusform>
            <numerusform>%Ln frames on channels beyond the first %1: their devices are not listed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln frames of devices beyond the first %1, which are not listed</source>
        <translation>
            <numerusform>%Ln frame of devices beyond the first %1, which are not listed</numerusform>
            <numerusform>%Ln frames of devices beyond the first %1, which are not listed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StatusText</name>
    <message numerus="yes">
        <source>%Ln commands not on the bus yet</source>
        <translation>
            <numerusform>%Ln command not on the bus yet</numerusform>
            <numerusform>%Ln commands not on the bus yet</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln frames not on the bus yet</source>
        <translation>
            <numerusform>%Ln frame not on the bus yet</numerusform>
            <numerusform>%Ln frames not on the bus yet</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln frames not sent</source>
        <translation>
            <numerusform>%Ln frame not sent</numerusform>
            <numerusform>%Ln frames not sent</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln frames were handed to the adapter and are not on the bus yet.</source>
        <translation>
            <numerusform>%Ln frame was handed to the adapter and is not on the bus yet.</numerusform>
            <numerusform>%Ln frames were handed to the adapter and are not on the bus yet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln frames were not taken by the adapter: they were not sent.</source>
        <translation>
            <numerusform>%Ln frame was not taken by the adapter: it was not sent.</numerusform>
            <numerusform>%Ln frames were not taken by the adapter: they were not sent.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln frames</source>
        <translation>
            <numerusform>%Ln frame</numerusform>
            <numerusform>%Ln frames</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln error frames</source>
        <translation>
            <numerusform>%Ln error frame</numerusform>
            <numerusform>%Ln error frames</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln unreadable lines</source>
        <translation>
            <numerusform>%Ln unreadable line</numerusform>
            <numerusform>%Ln unreadable lines</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln frames missing</source>
        <translation>
            <numerusform>%Ln frame missing</numerusform>
            <numerusform>%Ln frames missing</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln gaps, %1 in all</source>
        <translation>
            <numerusform>%Ln gap, %1 in all</numerusform>
            <numerusform>%Ln gaps, %1 in all</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln frames that were lost before they could be recorded</source>
        <translation>
            <numerusform>%Ln frame that was lost before it could be recorded</numerusform>
            <numerusform>%Ln frames that were lost before they could be recorded</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>what the recorder lost at %Ln places, as it says</source>
        <translation>
            <numerusform>what the recorder lost at %Ln place, as it says</numerusform>
            <numerusform>what the recorder lost at %Ln places, as it says</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln CAN FD frames, which are not held</source>
        <translation>
            <numerusform>%Ln CAN FD frame, which is not held</numerusform>
            <numerusform>%Ln CAN FD frames, which are not held</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln CAN XL frames, which are not held</source>
        <translation>
            <numerusform>%Ln CAN XL frame, which is not held</numerusform>
            <numerusform>%Ln CAN XL frames, which are not held</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln frames that are not classic CAN, which are not held</source>
        <translation>
            <numerusform>%Ln frame that is not classic CAN, which is not held</numerusform>
            <numerusform>%Ln frames that are not classic CAN, which are not held</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln frames were not on the bus when %1 was left. They may have gone out since or may
still go out, unless the interface was taken down.</source>
        <translation>
            <numerusform>%Ln frame was not on the bus when %1 was left. It may have gone out since or may
still go out, unless the interface was taken down.</numerusform>
            <numerusform>%Ln frames were not on the bus when %1 was left. They may have gone out since or may
still go out, unless the interface was taken down.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln frames may still go out</source>
        <translation>
            <numerusform>%Ln frame may still go out</numerusform>
            <numerusform>%Ln frames may still go out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln frames are not on the bus yet and may still go out; only taking the interface down takes them back.</source>
        <translation>
            <numerusform>%Ln frame is not on the bus yet and may still go out; only taking the interface down takes it back.</numerusform>
            <numerusform>%Ln frames are not on the bus yet and may still go out; only taking the interface down takes them back.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>what stood in %Ln lines of the file that it was saved from, which could not be read</source>
        <translation>
            <numerusform>what stood in %Ln line of the file that it was saved from, which could not be read</numerusform>
            <numerusform>what stood in %Ln lines of the file that it was saved from, which could not be read</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>perhaps what stood at %Ln places of the file that it was saved from, which was not whole</source>
        <translation>
            <numerusform>perhaps what stood at %Ln place of the file that it was saved from, which was not whole</numerusform>
            <numerusform>perhaps what stood at %Ln places of the file that it was saved from, which was not whole</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln frames that stood where the recording is damaged</source>
        <translation>
            <numerusform>%Ln frame that stood where the recording is damaged</numerusform>
            <numerusform>%Ln frames that stood where the recording is damaged</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>deckpipe::FaultLines</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>deckpipe::FileSendBar</name>
    <message numerus="yes">
        <source>%n packets skipped, %1 sent again</source>
        <translation>
            <numerusform>1 packet skipped, %1 sent again</numerusform>
            <numerusform>%n packets skipped, %1 sent again</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Gone through, but %n packets skipped and %1 sent again: what arrived is not known</source>
        <translation>
            <numerusform>Gone through, but 1 packet skipped and %1 sent again: what arrived is not known</numerusform>
            <numerusform>Gone through, but %n packets skipped and %1 sent again: what arrived is not known</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %Ln bytes</source>
        <translation>
            <numerusform>%1 of 1 byte</numerusform>
            <numerusform>%1 of %Ln bytes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>deckpipe::OverviewPanel</name>
    <message numerus="yes">
        <source>No monitor heard up to this place of the log.
Other devices in the list: %n.</source>
        <translation>
            <numerusform>No monitor heard up to this place of the log.
Other devices in the list: %n.</numerusform>
            <numerusform>No monitor heard up to this place of the log.
Other devices in the list: %n.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>deckpipe::PipeInput</name>
    <message numerus="yes">
        <source>Send %Ln lines</source>
        <translation>
            <numerusform>Send %Ln line</numerusform>
            <numerusform>Send %Ln lines</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>deckpipe::RecordingsList</name>
    <message numerus="yes">
        <source>%Ln earlier ones were not saved either.</source>
        <translation>
            <numerusform>One earlier one was not saved either.</numerusform>
            <numerusform>%Ln earlier ones were not saved either.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>deckpipe::RepeatBar</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>deckpipe::RequestPanel</name>
    <message numerus="yes">
        <source>%Ln answers too many</source>
        <translation>
            <numerusform>%Ln answer too many</numerusform>
            <numerusform>%Ln answers too many</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>deckpipe::SaveBar</name>
    <message numerus="yes">
        <source>; %Ln frames were added to them: who held which address</source>
        <translation>
            <numerusform>; %Ln frame was added to them: who held which address</numerusform>
            <numerusform>; %Ln frames were added to them: who held which address</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>deckpipe::SendingActions</name>
    <message numerus="yes">
        <source>&amp;End the repeated polls of %n devices</source>
        <translation>
            <numerusform>&amp;End the repeated polls of %n device</numerusform>
            <numerusform>&amp;End the repeated polls of %n devices</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>deckpipe::TerminalPanel</name>
    <message numerus="yes">
        <source>The device restarted %1: %Ln characters that were typed before were not taken.</source>
        <translation>
            <numerusform>The device restarted %1: %Ln character that was typed before was not taken.</numerusform>
            <numerusform>The device restarted %1: %Ln characters that were typed before were not taken.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>deckpipe::Timeline</name>
    <message numerus="yes">
        <source>%n marks</source>
        <translation>
            <numerusform>%n mark</numerusform>
            <numerusform>%n marks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>deckpipe::TracePanel</name>
    <message numerus="yes">
        <source>%Ln rows</source>
        <translation>
            <numerusform>%Ln row</numerusform>
            <numerusform>%Ln rows</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %Ln frames, %2</source>
        <translation>
            <numerusform>%1 of 1 frame, %2</numerusform>
            <numerusform>%1 of %Ln frames, %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; %Ln frames of further identifiers have none</source>
        <translation>
            <numerusform>%1; 1 frame of a further identifier has none</numerusform>
            <numerusform>%1; %Ln frames of further identifiers have none</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>deckpipe::TraceView</name>
    <message numerus="yes">
        <source>%Ln more selected rows are not copied: save the selection instead.</source>
        <translation>
            <numerusform>%Ln more selected row is not copied: save the selection instead.</numerusform>
            <numerusform>%Ln more selected rows are not copied: save the selection instead.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>deckpipe::TransportBar</name>
    <message numerus="yes">
        <source>%1 s, %Ln frames, %2/s</source>
        <translation>
            <numerusform>%1 s, 1 frame, %2/s</numerusform>
            <numerusform>%1 s, %Ln frames, %2/s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln frames</source>
        <translation>
            <numerusform>%Ln frame</numerusform>
            <numerusform>%Ln frames</numerusform>
        </translation>
    </message>
</context>
</TS>
