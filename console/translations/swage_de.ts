<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AttemptAdvice</name>
    <message>
        <source>Dropped: put it back with F7, or take it where it lies.</source>
        <translation>Gefallen: mit F7 zurücklegen, oder dort greifen, wo es liegt.</translation>
    </message>
    <message>
        <source>Held at the wrong place: open the jaws (B), and take it at the mark.</source>
        <translation>An der falschen Stelle gehalten: Backen öffnen (B) und an der Marke greifen.</translation>
    </message>
    <message>
        <source>Held at the wrong place: open the jaws, and take it at the mark.</source>
        <translation>An der falschen Stelle gehalten: Backen öffnen und an der Marke greifen.</translation>
    </message>
    <message>
        <source>The needle is bent: F7 puts back a straight one, or stop (Shift+F5) and begin anew (F5).</source>
        <translation>Die Nadel ist verbogen: F7 legt eine gerade zurück, oder beenden (Umschalt+F5) und neu beginnen (F5).</translation>
    </message>
</context>
<context>
    <name>MediumLook</name>
    <message>
        <source>Dry field</source>
        <translation>Trockenes Feld</translation>
    </message>
    <message>
        <source>Moist field</source>
        <translation>Feuchtes Feld</translation>
    </message>
    <message>
        <source>Under water</source>
        <translation>Unter Wasser</translation>
    </message>
    <message>
        <source>In a viscous fluid</source>
        <translation>In zäher Flüssigkeit</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>What the cues mean</source>
        <translation>Was die Hinweise bedeuten</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Over and under</source>
        <translation>Übereinander</translation>
    </message>
    <message>
        <source>Lines in turn (passive 3D)</source>
        <translation>Zeilen im Wechsel (passives 3D)</translation>
    </message>
    <message>
        <source>Chess board (DLP 3D)</source>
        <translation>Schachbrett (DLP-3D)</translation>
    </message>
    <message>
        <source>Red and cyan glasses, colour</source>
        <translation>Rot-Cyan-Brille, farbig</translation>
    </message>
    <message>
        <source>Red and cyan glasses, grey</source>
        <translation>Rot-Cyan-Brille, grau</translation>
    </message>
    <message>
        <source>Red and cyan glasses, least ghosts</source>
        <translation>Rot-Cyan-Brille, geringste Geisterbilder</translation>
    </message>
    <message>
        <source>One eye</source>
        <translation>Ein Auge</translation>
    </message>
    <message>
        <source>Left eye only</source>
        <translation>Nur linkes Auge</translation>
    </message>
    <message>
        <source>Right eye only</source>
        <translation>Nur rechtes Auge</translation>
    </message>
    <message>
        <source>Recovered</source>
        <translation>Wiederhergestellt</translation>
    </message>
    <message>
        <source>A curve needs %1 finished attempts. %2 more.</source>
        <translation>Eine Kurve braucht %1 abgeschlossene Versuche. Noch %2.</translation>
    </message>
    <message>
        <source>No curve: %1 Median of the last %2: %3 (%4 to %5).</source>
        <translation>Keine Kurve: %1 Median der letzten %2: %3 (%4 bis %5).</translation>
    </message>
    <message>
        <source>Learning curve: %1 at the first attempt, %2 at the latest</source>
        <translation>Lernkurve: %1 beim ersten Versuch, %2 beim letzten</translation>
    </message>
    <message>
        <source>; a plateau cannot be estimated from these attempts yet.</source>
        <translation>; ein Plateau lässt sich aus diesen Versuchen noch nicht schätzen.</translation>
    </message>
    <message>
        <source>, towards %1 (95 %: %2 to %3).</source>
        <translation>, gegen %1 (95 %: %2 bis %3).</translation>
    </message>
    <message>
        <source>Half-way after %1 attempts.</source>
        <translation>Die Hälfte ist nach %1 Versuchen erreicht.</translation>
    </message>
    <message>
        <source>lower is better</source>
        <translation>niedriger ist besser</translation>
    </message>
    <message>
        <source>higher is better</source>
        <translation>höher ist besser</translation>
    </message>
    <message>
        <source>best inside its band</source>
        <translation>am besten im Zielband</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>noch nie</translation>
    </message>
    <message>
        <source>today</source>
        <translation>heute</translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>gestern</translation>
    </message>
    <message>
        <source>%1 days ago</source>
        <translation>vor %1 Tagen</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Markierung</translation>
    </message>
    <message>
        <source>Not recorded</source>
        <translation>Nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation>Startwert %1</translation>
    </message>
    <message>
        <source>%1, %2 of 100</source>
        <translation>%1, %2 von 100</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 kann nicht geschrieben werden: %2</translation>
    </message>
    <message>
        <source>A lesson has a title.</source>
        <translation>Eine Lektion hat einen Titel.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made.</source>
        <translation>Der Ordner %1 kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>There is a lesson of that title already; give it another.</source>
        <translation>Eine Lektion mit diesem Titel gibt es schon; geben Sie ihr einen anderen.</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation>%1 kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>%1 is no lesson that can be edited here.</source>
        <translation>%1 ist keine Lektion, die hier bearbeitet werden kann.</translation>
    </message>
    <message>
        <source>%1 could not be put into the bin; nothing was deleted.</source>
        <translation>%1 konnte nicht in den Papierkorb gelegt werden; nichts wurde gelöscht.</translation>
    </message>
    <message>
        <source>%1: this ended the attempt</source>
        <translation>%1: damit endete der Versuch</translation>
    </message>
    <message>
        <source>%1 %2, at most %3 is asked</source>
        <translation>%1 %2, gefordert ist höchstens %3</translation>
    </message>
    <message>
        <source>%1 %2, within what is asked (%3)</source>
        <translation>%1 %2, im Rahmen des Geforderten (%3)</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation>%1 kann nicht geschrieben werden: %2.</translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation>Suche leeren</translation>
    </message>
    <message>
        <source>no room</source>
        <translation>kein Platz</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Bild speichern…</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Picture (*.png);;Drawing (*.svg);;Page (*.pdf)</source>
        <translation>Bild (*.png);;Zeichnung (*.svg);;Seite (*.pdf)</translation>
    </message>
    <message>
        <source>▲ %1: the poses of its needleholder are missing</source>
        <translation>▲ %1: die Stellungen seines Nadelhalters fehlen</translation>
    </message>
    <message>
        <source>● %1: of %2 by %3, until %4, worst residual %5 µm</source>
        <translation>● %1: %2, von %3, bis %4, größte Abweichung %5 µm</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>▲ lost for %1</source>
        <translation>▲ verloren seit %1</translation>
    </message>
    <message>
        <source>● runs</source>
        <translation>● läuft</translation>
    </message>
    <message>
        <source>‖ paused</source>
        <translation>‖ angehalten</translation>
    </message>
    <message>
        <source>■ finished</source>
        <translation>■ beendet</translation>
    </message>
    <message>
        <source>– closed</source>
        <translation>– geschlossen</translation>
    </message>
    <message>
        <source>○ ready</source>
        <translation>○ bereit</translation>
    </message>
    <message>
        <source>parts stopped: %1</source>
        <translation>Teile angehalten: %1</translation>
    </message>
    <message>
        <source>devices silent: %1</source>
        <translation>Geräte stumm: %1</translation>
    </message>
    <message>
        <source>steps lost: %1</source>
        <translation>Schritte verloren: %1</translation>
    </message>
    <message>
        <source>steps late: %1</source>
        <translation>Schritte zu spät: %1</translation>
    </message>
    <message>
        <source>solver short: %1</source>
        <translation>Löser ungenau: %1</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>● in order</source>
        <translation>● in Ordnung</translation>
    </message>
    <message>
        <source>lesson “%1”</source>
        <translation>Lektion „%1“</translation>
    </message>
    <message>
        <source>● on the screen</source>
        <translation>● am Bildschirm</translation>
    </message>
    <message>
        <source>○ sent</source>
        <translation>○ gesendet</translation>
    </message>
    <message>
        <source>✓ read</source>
        <translation>✓ gelesen</translation>
    </message>
    <message>
        <source>✓ taken</source>
        <translation>✓ genommen</translation>
    </message>
    <message>
        <source>– not now</source>
        <translation>– nicht jetzt</translation>
    </message>
    <message>
        <source>▲ that station does not have it</source>
        <translation>▲ der Platz hat sie nicht</translation>
    </message>
    <message>
        <source>▲ %1: %2 days old. Check it on a gauge, or calibrate anew</source>
        <translation>▲ %1: %2 Tage alt. Mit einem Kraftmesser prüfen oder neu kalibrieren</translation>
    </message>
    <message>
        <source>One after the other (shutter glasses)</source>
        <translation>Abwechselnd (Shutterbrille)</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, Zeile %2: %3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>And one more.</source>
        <translation>Und noch einer.</translation>
    </message>
    <message>
        <source>And %1 more.</source>
        <translation>Und %1 weitere.</translation>
    </message>
    <message>
        <source>There is a lesson called &quot;%1&quot; among your own already; delete or rename it first.</source>
        <translation>Unter den eigenen Lektionen gibt es schon eine namens „%1“; diese zuerst löschen oder umbenennen.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>recorded hand</source>
        <translation>aufgezeichnete Hand</translation>
    </message>
    <message>
        <source>device with forces</source>
        <translation>Gerät mit Kräften</translation>
    </message>
    <message>
        <source>device without forces</source>
        <translation>Gerät ohne Kräfte</translation>
    </message>
    <message>
        <source>timing: no fault</source>
        <translation>Zeitverhalten: fehlerfrei</translation>
    </message>
    <message>
        <source>timing: %L1 late and %L2 lost of %L3 steps</source>
        <translation>Zeitverhalten: %L1 späte und %L2 verlorene von %L3 Schritten</translation>
    </message>
    <message>
        <source>, no forces for %L1 s</source>
        <translation>, %L1 s ohne Kräfte</translation>
    </message>
    <message>
        <source>solver: not recorded</source>
        <translation>Löser: nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>solver: no fault</source>
        <translation>Löser: fehlerfrei</translation>
    </message>
    <message>
        <source>solver: %1</source>
        <translation>Löser: %1</translation>
    </message>
    <message>
        <source>no calibrated sensor</source>
        <translation>kein kalibrierter Sensor</translation>
    </message>
    <message>
        <source>lesson version %1</source>
        <translation>Lektionsversion %1</translation>
    </message>
    <message>
        <source>metrics by %1</source>
        <translation>Kennzahlen von %1</translation>
    </message>
    <message>
        <source>input: %1</source>
        <translation>Eingabe: %1</translation>
    </message>
    <message>
        <source>calibration: %1</source>
        <translation>Kalibrierung: %1</translation>
    </message>
    <message>
        <source>Guest</source>
        <translation>Gast</translation>
    </message>
    <message>
        <source>%L1 of %L2</source>
        <translation>%L1 von %L2</translation>
    </message>
    <message>
        <source>Decided by what was measured of: %1.</source>
        <translation>Entschieden durch das Gemessene von: %1.</translation>
    </message>
    <message>
        <source>Not passed, so without a score and left out: %1.</source>
        <translation>Nicht bestanden, daher ohne Punktzahl und weggelassen: %1.</translation>
    </message>
    <message>
        <source>Not passed, counted with what was measured: %1.</source>
        <translation>Nicht bestanden, mit dem Gemessenen gezählt: %1.</translation>
    </message>
    <message>
        <source>No metric decides it: it is left to an observer.</source>
        <translation>Keine Kennzahl entscheidet das: Es bleibt einem Beobachter überlassen.</translation>
    </message>
    <message>
        <source>%1, computed (%2 of %3 items)</source>
        <translation>%1, berechnet (%2 von %3 Kriterien)</translation>
    </message>
    <message>
        <source>Computed from metrics; %1 of %2 items. Items not decided by the program are not counted. Source: %3</source>
        <translation>Aus Kennzahlen berechnet; %1 von %2 Kriterien. Was das Programm nicht entscheidet, zählt nicht. Quelle: %3</translation>
    </message>
    <message>
        <source>The metrics of this attempt decide no item.</source>
        <translation>Die Kennzahlen dieses Versuchs entscheiden kein Kriterium.</translation>
    </message>
    <message>
        <source>Computed from metrics: %1, the mean of %2 of %3 items; items not decided by the program are not counted.</source>
        <translation>Aus Kennzahlen berechnet: %1, Mittel von %2 der %3 Kriterien; was das Programm nicht entscheidet, zählt nicht.</translation>
    </message>
    <message>
        <source>Instructor&apos;s rating: %1, the mean of %2 of %3 items.</source>
        <translation>Urteil der Lehrkraft: %1, Mittel von %2 der %3 Kriterien.</translation>
    </message>
    <message>
        <source>Recorded hand</source>
        <translation>Aufgezeichnete Hand</translation>
    </message>
    <message>
        <source>Recorded hand: %1</source>
        <translation>Aufgezeichnete Hand: %1</translation>
    </message>
    <message>
        <source>%1, computed of a failed attempt (%2 of %3 items)</source>
        <translation>%1, berechnet für einen nicht bestandenen Versuch (%2 von %3 Kriterien)</translation>
    </message>
    <message>
        <source>Not passed, and no mark of the whole: what a failed attempt lost is not counted in points. Computed from metrics: %1, the mean of %2 of %3 items.</source>
        <translation>Nicht bestanden, und keine Note des Ganzen: Was ein nicht bestandener Versuch verlor, wird nicht in Punkten gezählt. Aus Kennzahlen berechnet: %1, Mittel von %2 der %3 Kriterien.</translation>
    </message>
    <message>
        <source>From %1 to %2 is asked</source>
        <translation>Verlangt: %1 bis %2</translation>
    </message>
    <message>
        <source>At most %1 is asked</source>
        <translation>Verlangt: höchstens %1</translation>
    </message>
    <message>
        <source>At least %1 is asked</source>
        <translation>Verlangt: mindestens %1</translation>
    </message>
</context>
<context>
    <name>ReviewedAttempt</name>
    <message>
        <source>This attempt is no longer in the store.</source>
        <translation>Dieser Versuch ist nicht mehr im Speicher.</translation>
    </message>
    <message>
        <source>The attempt cannot be read: %1</source>
        <translation>Der Versuch kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>The other attempt cannot be read: %1</source>
        <translation>Der andere Versuch kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>%1 holds no attempt.</source>
        <translation>%1 enthält keinen Versuch.</translation>
    </message>
    <message>
        <source>%1 is a store of several attempts: start with --store to see them.</source>
        <translation>%1 ist eine Ablage mit mehreren Versuchen: mit --store starten, um sie zu sehen.</translation>
    </message>
</context>
<context>
    <name>SceneMarks</name>
    <message>
        <source>Across the wire</source>
        <translation>Quer zum Draht</translation>
    </message>
    <message>
        <source>Oblique by %1°: hold %2</source>
        <translation>Schräg um %1°: %2 halten</translation>
    </message>
</context>
<context>
    <name>ScenePainter</name>
    <message>
        <source>The 3D view needs OpenGL 3.3 (%1).
Everything else works: lessons run and are recorded.</source>
        <translation>Die 3D-Ansicht braucht OpenGL 3.3 (%1).
Alles andere geht: Lektionen laufen und werden aufgezeichnet.</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>Wound %1 %</source>
        <translation>Wunde %1 %</translation>
    </message>
    <message>
        <source>Wound</source>
        <translation>Wunde</translation>
    </message>
    <message>
        <source>Largest %1 %</source>
        <translation>Größte %1 %</translation>
    </message>
    <message>
        <source>Entry %1 %</source>
        <translation>Einstich %1 %</translation>
    </message>
    <message>
        <source>Exit %1 %</source>
        <translation>Ausstich %1 %</translation>
    </message>
    <message>
        <source>Seen from behind: left and right are exchanged</source>
        <translation>Von hinten gesehen: links und rechts sind vertauscht</translation>
    </message>
</context>
<context>
    <name>attempt_report</name>
    <message>
        <source>%L1 s</source>
        <translation>%L1 s</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Worst moments</source>
        <translation>Schlechteste Momente</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation>Startwert %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Void: %1</source>
        <translation>Ungültig: %1</translation>
    </message>
    <message>
        <source>Points lost</source>
        <translation>Verlorene Punkte</translation>
    </message>
    <message>
        <source>Of 100</source>
        <translation>Von 100</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Quelle: %1</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>Computed from metrics</source>
        <translation>Aus Kennzahlen berechnet</translation>
    </message>
    <message>
        <source>Instructor&apos;s rating</source>
        <translation>Urteil der Lehrkraft</translation>
    </message>
    <message>
        <source>not decided</source>
        <translation>nicht entschieden</translation>
    </message>
    <message>
        <source>Further moments, in the review: %1.</source>
        <translation>Weitere Momente, in der Auswertung: %1.</translation>
    </message>
</context>
<context>
    <name>command_line</name>
    <message>
        <source>Swage, the microsurgery trainer: runs lessons and shows progress.</source>
        <translation>Swage, der Trainer für Mikrochirurgie: führt Lektionen aus und zeigt den Fortschritt.</translation>
    </message>
    <message>
        <source>Lesson file, or kept attempt, to open.</source>
        <translation>Lektionsdatei oder aufgehobener Versuch, der geöffnet wird.</translation>
    </message>
    <message>
        <source>Start the lesson at once.</source>
        <translation>Die Lektion sofort starten.</translation>
    </message>
    <message>
        <source>The hand: mouse, expert, a plugin id, or a name from the lesson.</source>
        <translation>Die Hand: mouse, expert, die Kennung eines Plugins oder ein Name aus der Lektion.</translation>
    </message>
    <message>
        <source>Who practises.</source>
        <translation>Wer übt.</translation>
    </message>
    <message>
        <source>practice, test or demo.</source>
        <translation>practice, test oder demo.</translation>
    </message>
    <message>
        <source>Folder to look for plugins in first; may be repeated.</source>
        <translation>Ordner, in dem Plugins zuerst gesucht werden; mehrmals erlaubt.</translation>
    </message>
    <message>
        <source>Attempts database: a file, postgresql://user@host/database, or :none:.</source>
        <translation>Datenbank der Versuche: eine Datei, postgresql://user@host/database oder :none:.</translation>
    </message>
    <message>
        <source>Stock plugins only.</source>
        <translation>Nur mitgelieferte Plugins.</translation>
    </message>
    <message>
        <source>Seed of every attempt, so that targets and tremor are the same again; otherwise each attempt draws its own.</source>
        <translation>Startwert jedes Versuchs, damit Ziele und Tremor dieselben sind; sonst zieht jeder Versuch einen eigenen.</translation>
    </message>
    <message>
        <source>en or de; that of the system unless given.</source>
        <translation>en oder de; sonst die Sprache des Systems.</translation>
    </message>
    <message>
        <source>light, dark or contrast.</source>
        <translation>light, dark oder contrast.</translation>
    </message>
    <message>
        <source>thesis or safe: colours of the cues.</source>
        <translation>thesis oder safe: Farben der Hinweise.</translation>
    </message>
    <message>
        <source>orbit, side, top or near.</source>
        <translation>orbit, side, top oder near.</translation>
    </message>
    <message>
        <source>Open a recorded attempt: its id, or latest.</source>
        <translation>Einen aufgezeichneten Versuch öffnen: seine Kennung oder latest.</translation>
    </message>
    <message>
        <source>Size of the window, as in 1440x900.</source>
        <translation>Größe des Fensters, etwa 1440x900.</translation>
    </message>
    <message>
        <source>Write a picture of the window (with --trainee: of the trainee&apos;s) and quit.</source>
        <translation>Ein Bild des Fensters schreiben (mit --trainee: dessen Fenster) und enden.</translation>
    </message>
    <message>
        <source>When: seconds into the attempt, or after the window is there.</source>
        <translation>Wann: Sekunden im Versuch, oder nachdem das Fenster da ist.</translation>
    </message>
    <message>
        <source>What this station is called among those of the school; the machine&apos;s name unless given.</source>
        <translation>Wie dieser Platz unter denen der Schule heißt; ohne Angabe wie der Rechner.</translation>
    </message>
    <message>
        <source>run, lessons, courses, people, review, setup or stations.</source>
        <translation>run, lessons, courses, people, review, setup oder stations.</translation>
    </message>
    <message>
        <source>Show the trainee&apos;s view, for two eyes: side, over, lines, checker, anaglyph, grey, least, shutter, one, left or right.</source>
        <translation>Die Ansicht des Trainees für zwei Augen zeigen: side, over, lines, checker, anaglyph, grey, least, shutter, one, left oder right.</translation>
    </message>
    <message>
        <source>Beside the recorded attempt another one at the same lesson: its id.</source>
        <translation>Neben dem aufgezeichneten Versuch ein anderer an derselben Lektion: seine Kennung.</translation>
    </message>
    <message>
        <source>Notches of the wheel by which the --view of a --review is nearer; below 0 farther.</source>
        <translation>Rasten des Rads, um die die Ansicht (--view) eines --review näher ist; unter 0 ferner.</translation>
    </message>
</context>
<context>
    <name>course_next</name>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>%1 Test attempts counted, learning-curve test at %L2 of %L3</source>
        <translation>%1 Testversuche gezählt, Lernkurventest bei %L2 von %L3</translation>
    </message>
    <message>
        <source>only the first %1 Test attempts of a later day are missing, %2 done</source>
        <translation>es fehlen nur die ersten %1 Testversuche eines späteren Tages, davon %2 erbracht</translation>
    </message>
    <message>
        <source>%1 of %2 Test attempts in a row</source>
        <translation>%1 von %2 Testversuchen in Folge</translation>
    </message>
    <message>
        <source>%1: %2 of %3 lessons passed.</source>
        <translation>%1: %2 von %3 Lektionen bestanden.</translation>
    </message>
    <message>
        <source>Next: %1, %2.</source>
        <translation>Als Nächstes: %1, %2.</translation>
    </message>
    <message>
        <source>Not open yet in the course “%1”: %2.</source>
        <translation>Im Kurs „%1“ noch nicht offen: %2.</translation>
    </message>
    <message>
        <source>“%1” comes first (%2)</source>
        <translation>zuerst kommt „%1“ (%2)</translation>
    </message>
    <message>
        <source>only the first Test attempt of a later day is missing</source>
        <translation>nur der erste Testversuch eines späteren Tages fehlt</translation>
    </message>
    <message>
        <source>no passed Test attempt yet</source>
        <translation>noch kein bestandener Testversuch</translation>
    </message>
</context>
<context>
    <name>course_words</name>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>Passed when a learning-curve test of the Test attempts signals that the trainee fails rather %1 % of them than %2 %.</source>
        <translation>Bestanden, wenn ein Lernkurventest der Testversuche anzeigt, dass eher %1 % von ihnen misslingen als %2 %.</translation>
    </message>
    <message>
        <source>At most %1 attempts a day count.</source>
        <translation>Höchstens %1 Versuche am Tag zählen.</translation>
    </message>
    <message>
        <source>The first %1 of a day are warm-up.</source>
        <translation>Die ersten %1 eines Tages dienen dem Aufwärmen.</translation>
    </message>
    <message>
        <source>succeeds %1 times in 10: passes in %L2 of 100 cases</source>
        <translation>hat %1-mal von 10 Erfolg: besteht in %L2 von 100 Fällen</translation>
    </message>
    <message>
        <source>, typically after %1 attempts</source>
        <translation>, meist nach %1 Versuchen</translation>
    </message>
    <message>
        <source>No attempts of experts to try these limits on.</source>
        <translation>Keine Versuche von Experten, an denen sich diese Grenzen prüfen ließen.</translation>
    </message>
    <message>
        <source>%1 of %2 expert attempts pass and meet all %3 limits together.</source>
        <translation>%1 von %2 Expertenversuchen sind bestanden und halten alle %3 Grenzen zusammen ein.</translation>
    </message>
    <message>
        <source>The hardest alone is %1: %2.</source>
        <translation>Für sich allein ist %1 am schwersten: %2.</translation>
    </message>
    <message>
        <source>assumed: %1 attempts on every day</source>
        <translation>angenommen: %1 Versuche an jedem Tag</translation>
    </message>
    <message>
        <source>; the rule asks for a later day, so nobody passes before attempt %1</source>
        <translation>; die Regel verlangt einen späteren Tag, daher besteht niemand vor Versuch %1</translation>
    </message>
    <message>
        <source>one Test attempt meets everything that is asked</source>
        <translation>ein Testversuch alles Geforderte erfüllt</translation>
    </message>
    <message>
        <source>%1 Test attempts in a row meet everything that is asked</source>
        <translation>%1 Testversuche in Folge alles Geforderte erfüllen</translation>
    </message>
    <message>
        <source>Passed when %1.</source>
        <translation>Bestanden, wenn %1.</translation>
    </message>
    <message>
        <source>the first of a later day does so too</source>
        <translation>der erste eines späteren Tages ebenso</translation>
    </message>
    <message>
        <source>the first %1 of a later day do so too</source>
        <translation>die ersten %1 eines späteren Tages ebenso</translation>
    </message>
    <message>
        <source>Passed when %1, and %2.</source>
        <translation>Bestanden, wenn %1 und %2.</translation>
    </message>
    <message>
        <source>, typically with the first attempt</source>
        <translation>, meist mit dem ersten Versuch</translation>
    </message>
    <message>
        <source>%1 of %2 expert attempts pass and meet the limit.</source>
        <translation>%1 von %2 Expertenversuchen bestehen und halten die Grenze ein.</translation>
    </message>
</context>
<context>
    <name>group_report</name>
    <message>
        <source>not yet</source>
        <translation>noch nie</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1, %2 passed</source>
        <translation>%1, %2 bestanden</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Lessons passed</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Last score</source>
        <translation>Punkte zuletzt</translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation>Zuletzt da</translation>
    </message>
    <message>
        <source>Lessons of the course</source>
        <translation>Lektionen des Kurses</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Passed by</source>
        <translation>Bestanden von</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Alle Lektionen</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>A lesson is passed here when one attempt at it was.</source>
        <translation>Eine Lektion gilt hier als bestanden, wenn ein Versuch an ihr bestanden wurde.</translation>
    </message>
    <message>
        <source>A lesson is passed here when the rule of the course is met, in Test.</source>
        <translation>Eine Lektion gilt hier als bestanden, wenn die Regel des Kurses im Test erfüllt ist.</translation>
    </message>
    <message>
        <source>Attempts that count: by the person&apos;s own hand, ended by themselves, not void. Last score: of the newest passed one.</source>
        <translation>Es zählen Versuche von der Hand der Person, die von selbst endeten und gültig sind. Punkte zuletzt: des neuesten bestandenen.</translation>
    </message>
    <message>
        <source>%1 people, of whom %2 need attention.</source>
        <translation>%1 Personen, davon brauchen %2 Aufmerksamkeit.</translation>
    </message>
    <message>
        <source>%1 of %2 lessons passed.</source>
        <translation>%1 von %2 Lektionen bestanden.</translation>
    </message>
    <message>
        <source>Median of the last scores: %1.</source>
        <translation>Median der letzten Punktzahlen: %1.</translation>
    </message>
    <message>
        <source>▲ Needs attention: %1</source>
        <translation>▲ Braucht Aufmerksamkeit: %1</translation>
    </message>
</context>
<context>
    <name>lesson_facts</name>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>At the end the program pulls a copy of the knot, up to %1, and tells what it bears.</source>
        <translation>Am Ende zieht das Programm an einer Kopie des Knotens, bis %1, und sagt, was er hält.</translation>
    </message>
    <message>
        <source>At the end the program pulls a copy of the knot, up to %1: what it does not bear of that costs up to %L2 points.</source>
        <translation>Am Ende zieht das Programm an einer Kopie des Knotens, bis %1: was er davon nicht hält, kostet bis zu %L2 Punkte.</translation>
    </message>
</context>
<context>
    <name>metric_bars</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Experts</source>
        <translation>Experten</translation>
    </message>
    <message>
        <source>recorded expert hand</source>
        <translation>aufgezeichnete Expertenhand</translation>
    </message>
    <message>
        <source>1 expert</source>
        <translation>1 Experte</translation>
    </message>
    <message>
        <source>%1 experts</source>
        <translation>%1 Experten</translation>
    </message>
</context>
<context>
    <name>metric_titles</name>
    <message>
        <source>Score</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
</context>
<context>
    <name>people_courses</name>
    <message>
        <source>%1, until %2</source>
        <translation>%1, bis %2</translation>
    </message>
</context>
<context>
    <name>report</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source> Now: %1.</source>
        <translation> Jetzt: %1.</translation>
    </message>
    <message>
        <source>Latest attempt, experts&apos; band</source>
        <translation>Letzter Versuch, Band der Experten</translation>
    </message>
    <message>
        <source>Instructor&apos;s note: ______________________________________________</source>
        <translation>Anmerkung der Ausbilder: ______________________________________________</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation>%1 kann nicht geschrieben werden: %2.</translation>
    </message>
    <message>
        <source>%1 of %2 attempts at all lessons passed.</source>
        <translation>%1 von %2 Versuchen an allen Lektionen bestanden.</translation>
    </message>
    <message>
        <source>%1 of %2 attempts at this lesson passed.</source>
        <translation>%1 von %2 Versuchen an dieser Lektion bestanden.</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
</context>
<context>
    <name>roster</name>
    <message>
        <source>&quot;%1&quot; is neither left nor right</source>
        <translation>„%1“ ist weder links noch rechts</translation>
    </message>
    <message>
        <source>No name</source>
        <translation>Kein Name</translation>
    </message>
    <message>
        <source>Longer than %1 characters</source>
        <translation>Länger als %1 Zeichen</translation>
    </message>
    <message>
        <source>Is there already</source>
        <translation>Ist schon da</translation>
    </message>
    <message>
        <source>Twice in the list</source>
        <translation>Zweimal in der Liste</translation>
    </message>
</context>
<context>
    <name>sheet</name>
    <message>
        <source>Swage %1. For teaching, not for certification.</source>
        <translation>Swage %1. Für den Unterricht, nicht für Zeugnisse.</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
</context>
<context>
    <name>standing</name>
    <message>
        <source>%1 not passed in a row</source>
        <translation>%1 in Folge nicht bestanden</translation>
    </message>
    <message>
        <source>%1 not passed in a row: %2</source>
        <translation>%1 in Folge nicht bestanden: %2</translation>
    </message>
    <message>
        <source>%1 days without practice</source>
        <translation>%1 Tage ohne Übung</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>doing well</source>
        <translation>auf gutem Weg</translation>
    </message>
</context>
<context>
    <name>swage::console::ActionBar</name>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>Zurücklegen</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Markierung</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Führung</translation>
    </message>
    <message>
        <source>Remember the moment two seconds ago (F8)</source>
        <translation>Den Moment vor zwei Sekunden merken (F8)</translation>
    </message>
    <message>
        <source>An expert&apos;s instruments, seen through, show what comes next and wait for you; not in a test (F4)</source>
        <translation>Durchscheinende Instrumente eines Experten zeigen, was als Nächstes kommt, und warten auf Sie; nicht im Test (F4)</translation>
    </message>
    <message>
        <source>Resume   F6</source>
        <translation>Weiter   F6</translation>
    </message>
    <message>
        <source>Pause   F6</source>
        <translation>Pause   F6</translation>
    </message>
    <message>
        <source>Put what the lesson works on back to where it started</source>
        <translation>Woran die Lektion arbeitet, dorthin zurücklegen, wo es begann</translation>
    </message>
</context>
<context>
    <name>swage::console::ArmReader</name>
    <message>
        <source>The instrument cannot be opened.</source>
        <translation>Das Instrument kann nicht geöffnet werden.</translation>
    </message>
</context>
<context>
    <name>swage::console::AssignDialog</name>
    <message>
        <source>Assign a course</source>
        <translation>Kurs zuweisen</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>none: take back what was assigned</source>
        <translation>keiner: Zugewiesenes zurücknehmen</translation>
    </message>
    <message>
        <source>To</source>
        <translation>An</translation>
    </message>
    <message>
        <source>The chosen person</source>
        <translation>Die gewählte Person</translation>
    </message>
    <message>
        <source>The %1 chosen people</source>
        <translation>Die %1 gewählten Personen</translation>
    </message>
    <message>
        <source>Everybody in %1, also who joins later</source>
        <translation>Alle in %1, auch wer später dazukommt</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>There is no course yet: make one on the Courses page.</source>
        <translation>Es gibt noch keinen Kurs: legen Sie auf der Seite Kurse einen an.</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Zuweisen</translation>
    </message>
    <message>
        <source>d MMM yyyy</source>
        <translation>d. MMM yyyy</translation>
    </message>
</context>
<context>
    <name>swage::console::AttemptChooser</name>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>recorded hand</source>
        <translation>aufgezeichnete Hand</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Vergleichen mit</translation>
    </message>
    <message>
        <source>Search name, date and result</source>
        <translation>In Name, Datum und Ergebnis suchen</translation>
    </message>
    <message>
        <source>Attempts at the same lesson</source>
        <translation>Versuche derselben Lektion</translation>
    </message>
    <message>
        <source>There is no other attempt at this lesson in the store, of anybody.</source>
        <translation>Im Speicher ist von niemandem ein anderer Versuch an dieser Lektion.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>recorded hand: %1</source>
        <translation>aufgezeichnete Hand: %1</translation>
    </message>
    <message>
        <source>Attempts at this lesson, of everybody: those at another lesson have nothing to be compared.</source>
        <translation>Versuche an dieser Lektion, von allen: die an einer anderen haben nichts zu vergleichen.</translation>
    </message>
</context>
<context>
    <name>swage::console::AttemptExports</name>
    <message>
        <source>Report (PDF)</source>
        <translation>Bericht (PDF)</translation>
    </message>
    <message>
        <source>Pages to print: result, metrics, ratings, worst moments, traces, notes</source>
        <translation>Seiten zum Drucken: Ergebnis, Kennzahlen, Urteile, schlechteste Momente, Kurven, Notizen</translation>
    </message>
    <message>
        <source>Save pages about the attempt</source>
        <translation>Seiten über den Versuch speichern</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>The attempt as a file for other programs, or for another station</source>
        <translation>Der Versuch als Datei für andere Programme oder einen anderen Platz</translation>
    </message>
    <message>
        <source>Save attempt</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save the whole attempt</source>
        <translation>Den ganzen Versuch speichern</translation>
    </message>
    <message>
        <source>Everything in one file: swage replay and another station&apos;s Swage can read it</source>
        <translation>Alles in einer Datei: swage replay und das Swage eines anderen Platzes können sie lesen</translation>
    </message>
    <message>
        <source>Export signals (CSV)</source>
        <translation>Signale (CSV)</translation>
    </message>
    <message>
        <source>Save the signals</source>
        <translation>Die Signale speichern</translation>
    </message>
    <message>
        <source>A thousand lines a second, SI units</source>
        <translation>Tausend Zeilen je Sekunde, SI-Einheiten</translation>
    </message>
    <message>
        <source>Export summary (CSV)</source>
        <translation>Übersicht (CSV)</translation>
    </message>
    <message>
        <source>Save metrics and events</source>
        <translation>Kennzahlen und Ereignisse speichern</translation>
    </message>
    <message>
        <source>Facts, metrics, ratings and events</source>
        <translation>Angaben, Kennzahlen, Urteile und Ereignisse</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 kann nicht geschrieben werden: %2</translation>
    </message>
    <message>
        <source>Saved to: %1</source>
        <translation>Gespeichert unter: %1</translation>
    </message>
</context>
<context>
    <name>swage::console::AttemptOpener</name>
    <message>
        <source>Open an attempt</source>
        <translation>Versuch öffnen</translation>
    </message>
    <message>
        <source>Swage attempts (*.swage);;All files (*)</source>
        <translation>Swage-Versuche (*.swage);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>swage::console::AttemptPresenter</name>
    <message>
        <source>Mark</source>
        <translation>Markierung</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Pulling the knot: %1 of %2</source>
        <translation>Zug am Knoten: %1 von %2</translation>
    </message>
</context>
<context>
    <name>swage::console::AttemptsModel</name>
    <message>
        <source>%1 (voided by %2)</source>
        <translation>%1 (für ungültig erklärt: %2)</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Recorded hand, not counted</source>
        <translation>Aufgezeichnete Hand, zählt nicht</translation>
    </message>
    <message>
        <source>Recorded hand: %1</source>
        <translation>Aufgezeichnete Hand: %1</translation>
    </message>
    <message>
        <source>An attempt by a recorded hand counts for nobody.</source>
        <translation>Ein Versuch einer aufgezeichneten Hand zählt für niemanden.</translation>
    </message>
</context>
<context>
    <name>swage::console::BandBars</name>
    <message>
        <source>Latest values against the experts</source>
        <translation>Letzte Werte gegen die der Experten</translation>
    </message>
    <message>
        <source>%1 %2, experts %3</source>
        <translation>%1 %2, Experten %3</translation>
    </message>
    <message>
        <source>← better</source>
        <translation>← besser</translation>
    </message>
    <message>
        <source>Green, and in brackets: the middle 80 % of the experts. Ring: the latest attempt, filled within the band or better. A bar spans the experts&apos; band and all of this person&apos;s attempts.</source>
        <translation>Grün und in Klammern: die mittleren 80 % der Experten. Ring: der letzte Versuch, gefüllt im Band oder besser. Ein Balken umfasst das Band der Experten und alle Versuche dieser Person.</translation>
    </message>
    <message>
        <source>bar: all own attempts</source>
        <translation>Balken: alle eigenen Versuche</translation>
    </message>
</context>
<context>
    <name>swage::console::CalibrationDialog</name>
    <message>
        <source>Calibrate a jaw sensor</source>
        <translation>Backensensor kalibrieren</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Anschluss</translation>
    </message>
    <message>
        <source>Bits per second</source>
        <translation>Bit je Sekunde</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>○ Not connected</source>
        <translation>○ Nicht verbunden</translation>
    </message>
    <message>
        <source>Lengths on the bench</source>
        <translation>Längen auf der Messbank</translation>
    </message>
    <message>
        <source>Lengths and volts</source>
        <translation>Längen und Spannungen</translation>
    </message>
    <message>
        <source>Length, mm</source>
        <translation>Länge, mm</translation>
    </message>
    <message>
        <source>Volts</source>
        <translation>Volt</translation>
    </message>
    <message>
        <source>Residual, µm</source>
        <translation>Abw., µm</translation>
    </message>
    <message>
        <source>Measure this length</source>
        <translation>Diese Länge messen</translation>
    </message>
    <message>
        <source>Draw the sensor to the length of the chosen line, hold it still, press; the next line follows</source>
        <translation>Den Sensor auf die Länge der gewählten Zeile ausziehen, still halten, drücken; dann kommt die nächste Zeile</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>V</source>
        <translation>V</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Residuals, µm, and the band that is allowed</source>
        <translation>Abweichungen, µm, und das erlaubte Band</translation>
    </message>
    <message>
        <source>Poses of the needleholder</source>
        <translation>Stellungen des Nadelhalters</translation>
    </message>
    <message>
        <source>Open: let the handle go</source>
        <translation>Offen: den Griff loslassen</translation>
    </message>
    <message>
        <source>Just closed: the jaws meet</source>
        <translation>Gerade geschlossen: die Backen berühren sich</translation>
    </message>
    <message>
        <source>Squeezed: as far as it goes</source>
        <translation>Gedrückt: so weit es geht</translation>
    </message>
    <message>
        <source>Who calibrates</source>
        <translation>Wer kalibriert</translation>
    </message>
    <message>
        <source>Valid for </source>
        <translation>Gültig für </translation>
    </message>
    <message>
        <source> days</source>
        <translation> Tage</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Listening…</source>
        <translation>Hört…</translation>
    </message>
    <message>
        <source>%1 does not say who it is. Is it a sensor that speaks JAW1, and powered?</source>
        <translation>%1 sagt nicht, wer es ist. Ist es ein Sensor, der JAW1 spricht, und hat er Strom?</translation>
    </message>
    <message>
        <source>▲ %1: unplugged</source>
        <translation>▲ %1: ausgesteckt</translation>
    </message>
    <message>
        <source>● %1: %2 V</source>
        <translation>● %1: %2 V</translation>
    </message>
    <message>
        <source>▲ %1: beyond its range</source>
        <translation>▲ %1: außerhalb seines Bereichs</translation>
    </message>
    <message>
        <source>Hold it still…</source>
        <translation>Still halten…</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>weggelassen</translation>
    </message>
    <message>
        <source>%1 mm/V, worst residual %2 µm, rms %3 µm; %4 of %5 points left out, beyond the stroke.</source>
        <translation>%1 mm/V, größte Abweichung %2 µm, Effektivwert %3 µm; %4 von %5 Punkten weggelassen, außerhalb des Hubs.</translation>
    </message>
    <message>
        <source>Kept, valid until %1.</source>
        <translation>Behalten, gültig bis %1.</translation>
    </message>
    <message>
        <source>Kept, valid until %1. It is used once the three poses are measured.</source>
        <translation>Behalten, gültig bis %1. Sie wird benutzt, sobald die drei Stellungen gemessen sind.</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Stellungen</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Kräfte</translation>
    </message>
    <message>
        <source>Measure these three in each session; it takes 20 s. Lengths and forces of before stay.</source>
        <translation>Diese drei in jeder Sitzung messen; das dauert 20 s. Längen und Kräfte von vorher bleiben.</translation>
    </message>
    <message>
        <source>The stored lengths are used: worst residual %1 µm. Measure new ones where the sensor was mounted anew.</source>
        <translation>Die gespeicherten Längen gelten: größte Abweichung %1 µm. Neue messen, wenn der Sensor neu eingebaut wurde.</translation>
    </message>
    <message>
        <source>Forces of the handle and of the tips</source>
        <translation>Kräfte am Griff und an den Spitzen</translation>
    </message>
    <message>
        <source>Measure &quot;just closed&quot; first. Then squeeze, type what the scale at the handle shows and, with a gauge between the tips, what it shows; 5 to 11 rows.</source>
        <translation>Zuerst „gerade geschlossen“ messen. Dann drücken, eintragen, was die Waage am Griff zeigt, und, mit einem Kraftmesser zwischen den Spitzen, was er zeigt; 5 bis 11 Zeilen.</translation>
    </message>
    <message>
        <source>Forces and volts</source>
        <translation>Kräfte und Spannungen</translation>
    </message>
    <message>
        <source>At the handle, N</source>
        <translation>Am Griff, N</translation>
    </message>
    <message>
        <source>At the tips, N</source>
        <translation>An den Spitzen, N</translation>
    </message>
    <message>
        <source>Measure this force</source>
        <translation>Diese Kraft messen</translation>
    </message>
    <message>
        <source>Check at %1 N</source>
        <translation>Bei %1 N prüfen</translation>
    </message>
    <message>
        <source>A real needle between the tips on the gauge: squeeze until it shows this force, hold still, press</source>
        <translation>Eine echte Nadel zwischen den Spitzen auf dem Kraftmesser: drücken, bis er diese Kraft zeigt, still halten, klicken</translation>
    </message>
    <message>
        <source>Without new rows the forces of before stay; without any, force is shown and not scored.</source>
        <translation>Ohne neue Zeilen bleiben die Kräfte von vorher; ohne solche wird die Kraft gezeigt und nicht gewertet.</translation>
    </message>
    <message>
        <source>%1 N at the handle after %2 mm of travel; the tips are not measured.</source>
        <translation>%1 N am Griff nach %2 mm Weg; die Spitzen sind nicht gemessen.</translation>
    </message>
    <message>
        <source>%1 N at the handle after %2 mm of travel, %3 N at the tips.</source>
        <translation>%1 N am Griff nach %2 mm Weg, %3 N an den Spitzen.</translation>
    </message>
    <message>
        <source>Force at the tips: not calibrated</source>
        <translation>Kraft an den Spitzen: nicht kalibriert</translation>
    </message>
    <message>
        <source>Force at the tips now: %1 N</source>
        <translation>Kraft an den Spitzen jetzt: %1 N</translation>
    </message>
    <message>
        <source>%1 Now %2 N; checked: %3 N for %4 N</source>
        <translation>%1 Jetzt %2 N; geprüft: %3 N für %4 N</translation>
    </message>
    <message>
        <source>No sensor is plugged in; or type its port</source>
        <translation>Kein Sensor steckt; oder seinen Port eintippen</translation>
    </message>
    <message>
        <source>Or, where a session says that the handle does not rest where it was open: its zero alone, 5 s.</source>
        <translation>Oder, wo eine Sitzung sagt, dass der Griff nicht dort ruht, wo er offen war: nur seine Null, 5 s.</translation>
    </message>
    <message>
        <source>Set the zero: let the handle go</source>
        <translation>Null setzen: den Griff loslassen</translation>
    </message>
    <message>
        <source>: %1 mm</source>
        <translation>: %1 mm</translation>
    </message>
</context>
<context>
    <name>swage::console::CloseGuard</name>
    <message>
        <source>A lesson is running. Closing the window stops it.</source>
        <translation>Eine Lektion läuft. Wird das Fenster geschlossen, endet sie.</translation>
    </message>
    <message>
        <source>A lesson is running. Closing the window stops it; the attempt is kept as stopped.</source>
        <translation>Eine Lektion läuft. Wird das Fenster geschlossen, endet sie; der Versuch wird als abgebrochen aufbewahrt.</translation>
    </message>
    <message>
        <source>Close Swage?</source>
        <translation>Swage schließen?</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>Abbrechen und schließen</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weitermachen</translation>
    </message>
    <message>
        <source>The window was closed while a lesson ran: that attempt is kept as stopped.</source>
        <translation>Das Fenster wurde geschlossen, während eine Lektion lief: Der Versuch ist als abgebrochen aufbewahrt.</translation>
    </message>
</context>
<context>
    <name>swage::console::Comparison</name>
    <message>
        <source>Align</source>
        <translation>Ausrichten</translation>
    </message>
    <message>
        <source>Align the attempts at</source>
        <translation>Die Versuche ausrichten an</translation>
    </message>
    <message>
        <source>What lies at the same place of the timeline in both attempts</source>
        <translation>Was in beiden Versuchen an derselben Stelle der Zeitleiste liegt</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>Vergleich beenden</translation>
    </message>
    <message>
        <source>End the comparison (Esc)</source>
        <translation>Vergleich beenden (Esc)</translation>
    </message>
    <message>
        <source>The other attempt, replayed</source>
        <translation>Der andere Versuch, nachgespielt</translation>
    </message>
    <message>
        <source>The picture cannot be replayed: %1</source>
        <translation>Das Bild kann nicht nachgespielt werden: %1</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Ghost</source>
        <translation>Durchscheinend</translation>
    </message>
    <message>
        <source>Show these instruments in the other picture, too, seen through (G)</source>
        <translation>Diese Instrumente auch im anderen Bild zeigen, durchscheinend (G)</translation>
    </message>
    <message>
        <source>Other attempt</source>
        <translation>Anderer Versuch</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Right: %1; %2, %3</source>
        <translation>Rechts: %1; %2, %3</translation>
    </message>
</context>
<context>
    <name>swage::console::CoursesPage</name>
    <message>
        <source>No course yet. A course is a row of lessons with a rule that says when each is passed.</source>
        <translation>Noch kein Kurs. Ein Kurs ist eine Folge von Lektionen mit einer Regel, wann jede bestanden ist.</translation>
    </message>
    <message>
        <source>▲ not installed: </source>
        <translation>▲ nicht installiert: </translation>
    </message>
    <message>
        <source>▲ faulty: </source>
        <translation>▲ fehlerhaft: </translation>
    </message>
    <message>
        <source>%1  %3%2</source>
        <translation>%1  %3%2</translation>
    </message>
    <message>
        <source>Add a lesson</source>
        <translation>Lektion hinzufügen</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>Courses</source>
        <translation>Kurse</translation>
    </message>
    <message>
        <source>New course</source>
        <translation>Neuer Kurs</translation>
    </message>
    <message>
        <source>Course %1</source>
        <translation>Kurs %1</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the course; Ctrl+Z brings it back</source>
        <translation>Den Kurs entfernen; Strg+Z holt ihn zurück</translation>
    </message>
    <message>
        <source>Remove course</source>
        <translation>Kurs entfernen</translation>
    </message>
    <message>
        <source>Title of the course</source>
        <translation>Titel des Kurses</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>One after the other</source>
        <translation>Eine nach der anderen</translation>
    </message>
    <message>
        <source>Lessons of the course</source>
        <translation>Lektionen des Kurses</translation>
    </message>
    <message>
        <source>Lesson to add</source>
        <translation>Lektion zum Hinzufügen</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add the lesson behind the chosen one</source>
        <translation>Die Lektion hinter der gewählten einfügen</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Früher</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>Take the lesson out of the course</source>
        <translation>Die Lektion aus dem Kurs nehmen</translation>
    </message>
    <message>
        <source>Remove a lesson</source>
        <translation>Lektion entfernen</translation>
    </message>
    <message>
        <source>Open at any time, whatever the order</source>
        <translation>Jederzeit offen, unabhängig von der Reihenfolge</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>Add a lesson to say when it is passed.</source>
        <translation>Fügen Sie eine Lektion hinzu, um zu sagen, wann sie bestanden ist.</translation>
    </message>
    <message>
        <source>▲ This lesson is not installed here: nobody can do it at this station.</source>
        <translation>▲ Diese Lektion ist hier nicht installiert: An diesem Platz kann sie niemand machen.</translation>
    </message>
    <message>
        <source>▲ The file of this lesson is faulty: nobody can do it. %1</source>
        <translation>▲ Die Datei dieser Lektion ist fehlerhaft: Niemand kann sie machen. %1</translation>
    </message>
    <message>
        <source>A lesson opens when the one before it is passed: until then practice asks first, and a test needs an instructor&apos;s reason</source>
        <translation>Eine Lektion öffnet sich, wenn die davor bestanden ist: bis dahin fragt die Übung nach, und ein Test braucht eine Begründung der Ausbilder</translation>
    </message>
</context>
<context>
    <name>swage::console::CueLegend</name>
    <message>
        <source>Sound: %1</source>
        <translation>Ton: %1</translation>
    </message>
    <message>
        <source>on now</source>
        <translation>jetzt an</translation>
    </message>
    <message>
        <source>What the cues mean</source>
        <translation>Was die Hinweise bedeuten</translation>
    </message>
    <message>
        <source>Cues</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>This lesson shows no cues.</source>
        <translation>Diese Lektion zeigt keine Hinweise.</translation>
    </message>
    <message>
        <source>Cues — hidden, but for marks of the task</source>
        <translation>Hinweise — verborgen bis auf Marken der Aufgabe</translation>
    </message>
</context>
<context>
    <name>swage::console::EraseDialog</name>
    <message>
        <source>Erase a person</source>
        <translation>Person löschen</translation>
    </message>
    <message>
        <source>%1 and %2 attempts with their recordings, notes and marks are erased for good. There is no undo, and no backup brings them back.</source>
        <translation>%1 und %2 Versuche mit Aufzeichnungen, Notizen und Markierungen werden endgültig gelöscht. Das lässt sich nicht rückgängig machen, und keine Sicherung bringt sie zurück.</translation>
    </message>
    <message>
        <source>These files were written from this store and are not touched:
%1</source>
        <translation>Diese Dateien wurden aus diesem Speicher geschrieben und bleiben unberührt:
%1</translation>
    </message>
    <message>
        <source>Type the name to go on:</source>
        <translation>Geben Sie zum Fortfahren den Namen ein:</translation>
    </message>
    <message>
        <source>The name of who is to be erased</source>
        <translation>Der Name der Person, die gelöscht werden soll</translation>
    </message>
    <message>
        <source>Erase for good</source>
        <translation>Endgültig löschen</translation>
    </message>
</context>
<context>
    <name>swage::console::EventLog</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Was geschah</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
</context>
<context>
    <name>swage::console::FaultCard</name>
    <message>
        <source>Run without recording</source>
        <translation>Ohne Aufzeichnung ausführen</translation>
    </message>
    <message>
        <source>The lesson runs; nothing of this attempt is kept</source>
        <translation>Die Lektion läuft; von diesem Versuch bleibt nichts</translation>
    </message>
    <message>
        <source>▲ NOT RECORDED: nothing of this attempt is kept. %1</source>
        <translation>▲ NICHT AUFGEZEICHNET: von diesem Versuch bleibt nichts. %1</translation>
    </message>
    <message>
        <source>… and one more.</source>
        <translation>… und eines mehr.</translation>
    </message>
    <message>
        <source>… and %1 more.</source>
        <translation>… und %1 mehr.</translation>
    </message>
    <message>
        <source>This lesson cannot run:</source>
        <translation>Diese Lektion kann nicht ausgeführt werden:</translation>
    </message>
</context>
<context>
    <name>swage::console::FitPlot</name>
    <message>
        <source>%1 points, %2 of them in the fit</source>
        <translation>%1 Punkte, davon %2 in der Ausgleichsgeraden</translation>
    </message>
</context>
<context>
    <name>swage::console::ForceMeter</name>
    <message>
        <source>Jaw force</source>
        <translation>Backenkraft</translation>
    </message>
    <message>
        <source>%1, good from %2 to %3</source>
        <translation>%1, gut von %2 bis %3</translation>
    </message>
    <message>
        <source>no contact</source>
        <translation>kein Kontakt</translation>
    </message>
    <message>
        <source>no grasp</source>
        <translation>kein Griff</translation>
    </message>
    <message>
        <source>! too much</source>
        <translation>! zu viel</translation>
    </message>
    <message>
        <source>light</source>
        <translation>leicht</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
</context>
<context>
    <name>swage::console::GroupPlot</name>
    <message>
        <source>A metric of several people</source>
        <translation>Eine Kennzahl mehrerer Personen</translation>
    </message>
    <message>
        <source>%1, %2 attempts of %3 people in %4 lessons</source>
        <translation>%1, %2 Versuche von %3 Personen in %4 Lektionen</translation>
    </message>
    <message>
        <source>%1 people, in the order of their names</source>
        <translation>%1 Personen, in der Reihenfolge ihrer Namen</translation>
    </message>
    <message>
        <source>filled: passed; bar: mean</source>
        <translation>gefüllt: bestanden; Strich: Mittel</translation>
    </message>
    <message>
        <source>No judged attempt of the chosen people has this metric.</source>
        <translation>Kein gewerteter Versuch der gewählten Personen hat diese Kennzahl.</translation>
    </message>
</context>
<context>
    <name>swage::console::GuideControl</name>
    <message>
        <source>Expert</source>
        <translation>Experte</translation>
    </message>
    <message>
        <source>No guide</source>
        <translation>Keine Führung</translation>
    </message>
    <message>
        <source>The scripted expert does not pass this lesson as it is set.</source>
        <translation>Die aufgezeichnete Expertenhand besteht diese Lektion so, wie sie eingestellt ist, nicht.</translation>
    </message>
</context>
<context>
    <name>swage::console::HelpDialog</name>
    <message>
        <source>Keys and cues</source>
        <translation>Tasten und Hinweise</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>F5</source>
        <translation>F5</translation>
    </message>
    <message>
        <source>Start, again</source>
        <translation>Start, noch einmal</translation>
    </message>
    <message>
        <source>F6</source>
        <translation>F6</translation>
    </message>
    <message>
        <source>Pause, resume</source>
        <translation>Pause, weiter</translation>
    </message>
    <message>
        <source>F7</source>
        <translation>F7</translation>
    </message>
    <message>
        <source>F8</source>
        <translation>F8</translation>
    </message>
    <message>
        <source>Mark the moment two seconds ago</source>
        <translation>Den Moment vor zwei Sekunden markieren</translation>
    </message>
    <message>
        <source>Shift+F5</source>
        <translation>Umschalt+F5</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>F9</source>
        <translation>F9</translation>
    </message>
    <message>
        <source>Trainee&apos;s view; there F11 fills the screen</source>
        <translation>Ansicht des Trainees; dort füllt F11 den Bildschirm</translation>
    </message>
    <message>
        <source>F10</source>
        <translation>F10</translation>
    </message>
    <message>
        <source>Instructor&apos;s window: readings, cues, events</source>
        <translation>Fenster der Ausbilder: Anzeigen, Hinweise, Ereignisse</translation>
    </message>
    <message>
        <source>Ctrl+1, 2, 3 ...</source>
        <translation>Strg+1, 2, 3 ...</translation>
    </message>
    <message>
        <source>Go to a page</source>
        <translation>Zu einer Seite gehen</translation>
    </message>
    <message>
        <source>Ctrl+Z,  Ctrl+Y</source>
        <translation>Strg+Z,  Strg+Y</translation>
    </message>
    <message>
        <source>Undo, redo</source>
        <translation>Rückgängig, wiederholen</translation>
    </message>
    <message>
        <source>F12</source>
        <translation>F12</translation>
    </message>
    <message>
        <source>Show frame rate</source>
        <translation>Bildrate zeigen</translation>
    </message>
    <message>
        <source>F1</source>
        <translation>F1</translation>
    </message>
    <message>
        <source>This page</source>
        <translation>Diese Seite</translation>
    </message>
    <message>
        <source>Instrument: mouse and keyboard</source>
        <translation>Instrument: Maus und Tastatur</translation>
    </message>
    <message>
        <source>Left drag,  A D W S</source>
        <translation>Ziehen links,  A D W S</translation>
    </message>
    <message>
        <source>Move across</source>
        <translation>Quer bewegen</translation>
    </message>
    <message>
        <source>Wheel,  Q E</source>
        <translation>Rad,  Q E</translation>
    </message>
    <message>
        <source>Move away, come nearer</source>
        <translation>Entfernen, annähern</translation>
    </message>
    <message>
        <source>Right drag,  arrows</source>
        <translation>Ziehen rechts,  Pfeile</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Ctrl+right drag,  Z X</source>
        <translation>Strg+Ziehen rechts,  Z X</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>C+left drag,  T G</source>
        <translation>C+Ziehen links,  T G</translation>
    </message>
    <message>
        <source>Drive the needle along its own curve</source>
        <translation>Die Nadel entlang ihrer Krümmung führen</translation>
    </message>
    <message>
        <source>Middle button,  Space</source>
        <translation>Mittlere Taste,  Leertaste</translation>
    </message>
    <message>
        <source>Hold: close the jaws to a good grip; again: further</source>
        <translation>Halten: die Backen zu einem guten Griff schließen; noch einmal: weiter</translation>
    </message>
    <message>
        <source>Ctrl+middle,  B</source>
        <translation>Strg+Mitte,  B</translation>
    </message>
    <message>
        <source>Open the jaws</source>
        <translation>Die Backen öffnen</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Strg+Rad</translation>
    </message>
    <message>
        <source>Close, open in small steps</source>
        <translation>In kleinen Schritten schließen, öffnen</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>Everything finer</source>
        <translation>Alles feiner</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>The other instrument, where there are two</source>
        <translation>Das andere Instrument, wo es zwei gibt</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Drag,  arrows</source>
        <translation>Ziehen,  Pfeile</translation>
    </message>
    <message>
        <source>Turn the camera</source>
        <translation>Die Kamera drehen</translation>
    </message>
    <message>
        <source>Right drag, Shift+drag</source>
        <translation>Ziehen rechts, Umschalt+Ziehen</translation>
    </message>
    <message>
        <source>Shift the camera</source>
        <translation>Die Kamera verschieben</translation>
    </message>
    <message>
        <source>Wheel,  + −</source>
        <translation>Rad,  + −</translation>
    </message>
    <message>
        <source>Nearer, further</source>
        <translation>Näher, weiter weg</translation>
    </message>
    <message>
        <source>Double click,  Home</source>
        <translation>Doppelklick,  Pos1</translation>
    </message>
    <message>
        <source>Frame the scene</source>
        <translation>Die Szene ganz zeigen</translation>
    </message>
    <message>
        <source>Ctrl+drag</source>
        <translation>Strg+Ziehen</translation>
    </message>
    <message>
        <source>Turn the camera while the mouse is the instrument</source>
        <translation>Kamera drehen, während die Maus das Instrument ist</translation>
    </message>
    <message>
        <source>Ctrl+Shift+wheel</source>
        <translation>Strg+Umschalt+Rad</translation>
    </message>
    <message>
        <source>Camera nearer, further while the mouse is the instrument</source>
        <translation>Kamera näher, weiter weg, während die Maus das Instrument ist</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Play, pause</source>
        <translation>Abspielen, Pause</translation>
    </message>
    <message>
        <source>← →</source>
        <translation>← →</translation>
    </message>
    <message>
        <source>10 ms back, on</source>
        <translation>10 ms zurück, vor</translation>
    </message>
    <message>
        <source>Shift+← →</source>
        <translation>Umschalt+← →</translation>
    </message>
    <message>
        <source>1 ms</source>
        <translation>1 ms</translation>
    </message>
    <message>
        <source>Ctrl+← →</source>
        <translation>Strg+← →</translation>
    </message>
    <message>
        <source>1 s</source>
        <translation>1 s</translation>
    </message>
    <message>
        <source>Home,  End</source>
        <translation>Pos1,  Ende</translation>
    </message>
    <message>
        <source>Start, end</source>
        <translation>Anfang, Ende</translation>
    </message>
    <message>
        <source>,  .</source>
        <translation>,  .</translation>
    </message>
    <message>
        <source>Event before, after</source>
        <translation>Ereignis davor, danach</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>Loop around the cursor</source>
        <translation>Schleife um die Marke</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Note at the cursor</source>
        <translation>Notiz an der Marke</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Strg+E</translation>
    </message>
    <message>
        <source>Save the attempt</source>
        <translation>Den Versuch speichern</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Strg+Umschalt+E</translation>
    </message>
    <message>
        <source>Save its signals</source>
        <translation>Seine Signale speichern</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>F4</source>
        <translation>F4</translation>
    </message>
    <message>
        <source>An expert&apos;s instruments as a guide</source>
        <translation>Instrumente eines Experten als Führung</translation>
    </message>
    <message>
        <source>F3,  Shift+F3</source>
        <translation>F3,  Umschalt+F3</translation>
    </message>
    <message>
        <source>What the instructor sent: read or taken, not now</source>
        <translation>Was die Ausbilder schicken: gelesen oder angenommen, jetzt nicht</translation>
    </message>
    <message>
        <source>Ctrl+Page up, down</source>
        <translation>Strg+Bild auf, ab</translation>
    </message>
    <message>
        <source>Zoom of the microscope; with Shift its focus</source>
        <translation>Zoom des Mikroskops; mit Umschalt sein Fokus</translation>
    </message>
    <message>
        <source>Cues</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Ctrl+N,  Ctrl+E</source>
        <translation>Strg+N,  Strg+E</translation>
    </message>
    <message>
        <source>A lesson of your own, based on the chosen one; edit it</source>
        <translation>Eine eigene Lektion nach der gewählten; sie bearbeiten</translation>
    </message>
    <message>
        <source>Ctrl+I,  Ctrl+Shift+E</source>
        <translation>Strg+I,  Strg+Umschalt+E</translation>
    </message>
    <message>
        <source>Lessons page: import, export a lesson</source>
        <translation>Seite Lektionen: eine Lektion importieren, exportieren</translation>
    </message>
    <message>
        <source>Ctrl+R,  Ctrl+Shift+S</source>
        <translation>Strg+R,  Strg+Umschalt+S</translation>
    </message>
    <message>
        <source>Save its page, its summary</source>
        <translation>Seine Seite, seine Zusammenfassung speichern</translation>
    </message>
    <message>
        <source>Ctrl+Shift+P</source>
        <translation>Strg+Umschalt+P</translation>
    </message>
    <message>
        <source>Save the plot that has the keyboard, as PNG, SVG or PDF</source>
        <translation>Das Diagramm mit dem Tastaturfokus speichern: PNG, SVG, PDF</translation>
    </message>
    <message>
        <source>Ctrl+R,  Ctrl+→</source>
        <translation>Strg+R,  Strg+→</translation>
    </message>
    <message>
        <source>After an attempt: review it; the next lesson</source>
        <translation>Nach einem Versuch: ihn ansehen; die nächste Lektion</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>While an attempt runs: what is asked, and the limits</source>
        <translation>Während eines Versuchs: was verlangt ist, und die Grenzen</translation>
    </message>
    <message>
        <source>Enter,  Space</source>
        <translation>Eingabe,  Leertaste</translation>
    </message>
    <message>
        <source>Press the button that has the keyboard</source>
        <translation>Die Schaltfläche drücken, die die Tastatur hat</translation>
    </message>
    <message>
        <source>Ctrl+Q</source>
        <translation>Strg+Q</translation>
    </message>
    <message>
        <source>Quit; asks while a lesson runs</source>
        <translation>Beenden; fragt nach, solange eine Lektion läuft</translation>
    </message>
    <message>
        <source>Put what the lesson works on back</source>
        <translation>Woran die Lektion arbeitet, zurücklegen</translation>
    </message>
    <message>
        <source>Trainee&apos;s handbook</source>
        <translation>Handbuch für Übende</translation>
    </message>
    <message>
        <source>Instructor&apos;s handbook</source>
        <translation>Handbuch für Lehrende</translation>
    </message>
    <message>
        <source>Orbit Side Top Near,  F11</source>
        <translation>Kreisen Seite Oben Nah,  F11</translation>
    </message>
    <message>
        <source>Go to a view; to the next one</source>
        <translation>Zu einer Ansicht gehen; zur nächsten</translation>
    </message>
</context>
<context>
    <name>swage::console::InstructorControl</name>
    <message>
        <source>Readings in a test</source>
        <translation>Anzeigen im Test</translation>
    </message>
    <message>
        <source>The trainee sees this screen. If the readings are shown, the attempt and its result tell that they were open.</source>
        <translation>Diesen Bildschirm sieht der Trainee. Werden die Anzeigen gezeigt, sagen Versuch und Ergebnis, dass sie offen waren.</translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>The readings were open on the trainee&apos;s screen.</source>
        <translation>Die Anzeigen waren auf dem Bildschirm des Trainees offen.</translation>
    </message>
</context>
<context>
    <name>swage::console::InstructorWindow</name>
    <message>
        <source>Swage: instructor</source>
        <translation>Swage: Ausbilder</translation>
    </message>
</context>
<context>
    <name>swage::console::LessonDraft</name>
    <message>
        <source>Changes from before</source>
        <translation>Änderungen von vorher</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Learning goal</source>
        <translation>Lernziel</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made.</source>
        <translation>Der Ordner %1 kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>View at the start</source>
        <translation>Ansicht zu Beginn</translation>
    </message>
</context>
<context>
    <name>swage::console::LessonEditing</name>
    <message>
        <source>Delete lesson</source>
        <translation>Lektion löschen</translation>
    </message>
    <message>
        <source>&quot;%1&quot;</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>It was not deleted: these lessons are based on it and could not run without it: %1.</source>
        <translation>Sie wurde nicht gelöscht: diese Lektionen bauen auf ihr auf und liefen ohne sie nicht: %1.</translation>
    </message>
    <message>
        <source>The lesson goes into the bin. Attempts at it stay.</source>
        <translation>Die Lektion kommt in den Papierkorb. Versuche daran bleiben.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Lessons cannot be imported while one is running.</source>
        <translation>Lektionen können nicht importiert werden, während eine läuft.</translation>
    </message>
    <message>
        <source>The lesson &quot;%1&quot; is here already.</source>
        <translation>Die Lektion „%1“ ist schon hier.</translation>
    </message>
    <message>
        <source>It is part of these courses: %1.</source>
        <translation>Sie gehört zu diesen Kursen: %1.</translation>
    </message>
</context>
<context>
    <name>swage::console::LessonRequests</name>
    <message>
        <source>Saved as a lesson of your own.</source>
        <translation>Als eigene Lektion gespeichert.</translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>The lesson was imported.</source>
        <translation>Die Lektion wurde importiert.</translation>
    </message>
    <message>
        <source>Saved to: %1</source>
        <translation>Gespeichert unter: %1</translation>
    </message>
</context>
<context>
    <name>swage::console::LessonsPage</name>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Search title, task and goal</source>
        <translation>In Titel, Aufgabe und Ziel suchen</translation>
    </message>
    <message>
        <source>Practise</source>
        <translation>Üben</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>New lesson from this…</source>
        <translation>Neue Lektion hieraus…</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Bearbeiten…</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Löschen…</translation>
    </message>
    <message>
        <source>Publish</source>
        <translation>Veröffentlichen</translation>
    </message>
    <message>
        <source>Keep this lesson as it is now, as a version that courses and attempts refer to</source>
        <translation>Diese Lektion behalten, wie sie jetzt ist: als Fassung, auf die sich Kurse und Versuche beziehen</translation>
    </message>
    <message>
        <source>Retire</source>
        <translation>Zurückziehen</translation>
    </message>
    <message>
        <source>No lessons found. Put lesson files into %1.</source>
        <translation>Keine Lektionen gefunden. Legen Sie Lektionsdateien in %1.</translation>
    </message>
    <message>
        <source>No lesson has these words. Clear the search to see all.</source>
        <translation>Keine Lektion enthält diese Wörter. Leeren Sie die Suche, um alle zu sehen.</translation>
    </message>
    <message>
        <source>Not published: attempts refer to the file as it is when they run.</source>
        <translation>Nicht veröffentlicht: Versuche beziehen sich auf die Datei, wie sie beim Ausführen ist.</translation>
    </message>
    <message>
        <source>Retire version %1</source>
        <translation>Fassung %1 zurückziehen</translation>
    </message>
    <message>
        <source>Offer version %1 again</source>
        <translation>Fassung %1 wieder anbieten</translation>
    </message>
    <message>
        <source>Published as version %1, %2.</source>
        <translation>Veröffentlicht als Fassung %1, %2.</translation>
    </message>
    <message>
        <source>▲ Changed since version %1 was published, %2.</source>
        <translation>▲ Geändert, seit Fassung %1 veröffentlicht wurde, %2.</translation>
    </message>
    <message>
        <source>It is retired.</source>
        <translation>Sie ist zurückgezogen.</translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>Choose a lesson.</source>
        <translation>Wählen Sie eine Lektion.</translation>
    </message>
    <message>
        <source>▲ It cannot run: %1</source>
        <translation>▲ Sie kann nicht ausgeführt werden: %1</translation>
    </message>
    <message>
        <source>A demonstration</source>
        <translation>Eine Vorführung</translation>
    </message>
    <message>
        <source>Passed when</source>
        <translation>Bestanden, wenn</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importieren…</translation>
    </message>
    <message>
        <source>Take in a lesson file from another station</source>
        <translation>Die Lektionsdatei eines anderen Platzes aufnehmen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Export…</translation>
    </message>
    <message>
        <source>Write this lesson to a file for another station</source>
        <translation>Diese Lektion für einen anderen Platz in eine Datei schreiben</translation>
    </message>
    <message>
        <source>Import a lesson</source>
        <translation>Eine Lektion importieren</translation>
    </message>
    <message>
        <source>Lessons (*.json)</source>
        <translation>Lektionen (*.json)</translation>
    </message>
    <message>
        <source>Export the lesson</source>
        <translation>Die Lektion exportieren</translation>
    </message>
    <message>
        <source>A lesson is running. Until it ends, no lesson can be changed or started.</source>
        <translation>Eine Lektion läuft. Bis sie endet, kann keine geändert oder begonnen werden.</translation>
    </message>
    <message>
        <source>Limits in a test</source>
        <translation>Grenzen im Test</translation>
    </message>
    <message>
        <source>Ends every attempt</source>
        <translation>Beendet jeden Versuch</translation>
    </message>
</context>
<context>
    <name>swage::console::LimitsPanel</name>
    <message>
        <source>Points lost: %1</source>
        <translation>Verlorene Punkte: %1</translation>
    </message>
    <message>
        <source>Limits, besides the lesson&apos;s own verdict</source>
        <translation>Grenzen, neben dem eigenen Urteil der Lektion</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>At least</source>
        <translation>Mindestens</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>F2 or a double click changes a value; empty asks for nothing</source>
        <translation>F2 oder ein Doppelklick ändert einen Wert; leer fordert nichts</translation>
    </message>
    <message>
        <source>Metric to limit</source>
        <translation>Kennzahl zum Begrenzen</translation>
    </message>
    <message>
        <source>The metrics of this lesson are not known here</source>
        <translation>Die Kennzahlen dieser Lektion sind hier nicht bekannt</translation>
    </message>
    <message>
        <source>Each limit such that all but the worst tenth of the experts&apos; attempts keep it</source>
        <translation>Jede Grenze so, dass alle bis auf das schlechteste Zehntel der Expertenversuche sie einhalten</translation>
    </message>
    <message>
        <source>Add limit</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Remove limit</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>From experts</source>
        <translation>Nach Experten</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>No limits: the lesson&apos;s own verdict is all that is asked.</source>
        <translation>Keine Grenzen: gefordert ist nur das eigene Urteil der Lektion.</translation>
    </message>
    <message>
        <source>The metrics of this lesson are not known here: is it installed?</source>
        <translation>Die Kennzahlen dieser Lektion sind hier nicht bekannt: Ist sie installiert?</translation>
    </message>
    <message>
        <source>Add a limit</source>
        <translation>Grenze hinzufügen</translation>
    </message>
    <message>
        <source>Remove a limit</source>
        <translation>Grenze entfernen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number; no limit is added.</source>
        <translation>„%1“ ist keine Zahl; es wird keine Grenze hinzugefügt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number; the limit stays as it was.</source>
        <translation>„%1“ ist keine Zahl; die Grenze bleibt, wie sie war.</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>There is no limit yet to take from the experts: add one first.</source>
        <translation>Es gibt noch keine Grenze, die von den Experten kommen könnte: zuerst eine hinzufügen.</translation>
    </message>
    <message>
        <source>No attempts of experts at this lesson: no limit is changed. Experts are the people of the group &quot;Experts&quot;.</source>
        <translation>Keine Versuche von Experten an dieser Lektion: keine Grenze wird geändert. Experten sind die Personen der Gruppe „Experten“.</translation>
    </message>
    <message>
        <source>Limits from experts</source>
        <translation>Grenzen nach Experten</translation>
    </message>
</context>
<context>
    <name>swage::console::LiveForm</name>
    <message>
        <source>%1, %2 of %3</source>
        <translation>%1, %2 von %3</translation>
    </message>
    <message>
        <source>Back to the lesson&apos;s own value</source>
        <translation>Zurück zum eigenen Wert der Lektion</translation>
    </message>
    <message>
        <source>%1: back to the lesson&apos;s own value</source>
        <translation>%1: zurück zum eigenen Wert der Lektion</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Nothing of this lesson may be changed while it runs.</source>
        <translation>Nichts an dieser Lektion darf geändert werden, während sie läuft.</translation>
    </message>
    <message>
        <source>A change acts at once and is recorded.</source>
        <translation>Eine Änderung wirkt sofort und wird aufgezeichnet.</translation>
    </message>
    <message>
        <source>Can be changed while the lesson runs.</source>
        <translation>Kann geändert werden, während die Lektion läuft.</translation>
    </message>
    <message>
        <source>from </source>
        <translation>von </translation>
    </message>
    <message>
        <source>to </source>
        <translation>bis </translation>
    </message>
    <message>
        <source>by </source>
        <translation>mal </translation>
    </message>
    <message>
        <source>What you change here is written into the lesson; all else stays as it is. Values that are rarely changed are found by their name.</source>
        <translation>Was Sie hier ändern, wird in die Lektion geschrieben; alles andere bleibt, wie es ist. Selten geänderte Werte findet man über ihren Namen.</translation>
    </message>
</context>
<context>
    <name>swage::console::MainWindow</name>
    <message>
        <source>Swage</source>
        <translation>Swage</translation>
    </message>
    <message>
        <source>Picture: %1</source>
        <translation>Bild: %1</translation>
    </message>
    <message>
        <source>▲ No OpenGL</source>
        <translation>▲ Kein OpenGL</translation>
    </message>
    <message>
        <source>Trainee view</source>
        <translation>Trainee</translation>
    </message>
    <message>
        <source>Settings of the trainee view</source>
        <translation>Einstellungen der Ansicht des Trainees</translation>
    </message>
    <message>
        <source>Settings of the trainee view: screen, layout, eyes</source>
        <translation>Einstellungen der Ansicht des Trainees: Bildschirm, Anordnung, Augen</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Show frame rate</source>
        <translation>Bildrate zeigen</translation>
    </message>
    <message>
        <source>Open an attempt</source>
        <translation>Versuch öffnen</translation>
    </message>
    <message>
        <source>Eyes…</source>
        <translation>Augen…</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>The scene for two eyes in a window of its own; on the Review page, the replay (F9)</source>
        <translation>Die Szene für zwei Augen in einem eigenen Fenster; auf der Seite Auswertung die Wiedergabe (F9)</translation>
    </message>
</context>
<context>
    <name>swage::console::MessageStrip</name>
    <message>
        <source>Not now</source>
        <translation>Nicht jetzt</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Gelesen</translation>
    </message>
    <message>
        <source>next lesson: %1</source>
        <translation>nächste Lektion: %1</translation>
    </message>
    <message>
        <source>%1   (and %2 more)</source>
        <translation>%1   (und %2 weitere)</translation>
    </message>
    <message>
        <source>Take it after this attempt</source>
        <translation>Nach diesem Versuch nehmen</translation>
    </message>
    <message>
        <source>Take it</source>
        <translation>Nehmen</translation>
    </message>
</context>
<context>
    <name>swage::console::MetricChart</name>
    <message>
        <source>Metric over attempts</source>
        <translation>Kennzahl über die Versuche</translation>
    </message>
    <message>
        <source>no attempts</source>
        <translation>keine Versuche</translation>
    </message>
    <message>
        <source>%1, %2 attempts, first %L3, latest %L4 %5</source>
        <translation>%1, %2 Versuche, erster %L3, letzter %L4 %5</translation>
    </message>
    <message>
        <source>attempt</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>target %1 to %2 %3</source>
        <translation>Ziel %1 bis %2 %3</translation>
    </message>
    <message>
        <source>target at most %1 %2</source>
        <translation>Ziel höchstens %1 %2</translation>
    </message>
    <message>
        <source>target at least %1 %2</source>
        <translation>Ziel mindestens %1 %2</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>No finished attempt has this number yet.</source>
        <translation>Noch kein abgeschlossener Versuch hat diese Zahl.</translation>
    </message>
</context>
<context>
    <name>swage::console::MetricsTable</name>
    <message>
        <source>Metric</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Better</source>
        <translation>Besser</translation>
    </message>
    <message>
        <source>Other attempt</source>
        <translation>Anderer Versuch</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Kennzahlen</translation>
    </message>
    <message>
        <source>Points lost, of 100</source>
        <translation>Verlorene Punkte, von 100</translation>
    </message>
    <message>
        <source>What each fault has cost of the score</source>
        <translation>Was jeder Fehler an Punkten gekostet hat</translation>
    </message>
    <message>
        <source>%1, beyond the limit. %2</source>
        <translation>%1, außerhalb der Grenze. %2</translation>
    </message>
</context>
<context>
    <name>swage::console::MomentsTable</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Was geschah</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>%L1 s</source>
        <translation>%L1 s</translation>
    </message>
</context>
<context>
    <name>swage::console::NowPanel</name>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Press START, then follow the marks in the picture.</source>
        <translation>Drücken Sie START und folgen Sie den Zeichen im Bild.</translation>
    </message>
    <message>
        <source>Jaw force</source>
        <translation>Backenkraft</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>Tips</source>
        <translation>Spitzen</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Adjust</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Force and tilt of the last ten seconds</source>
        <translation>Kraft und Neigung der letzten zehn Sekunden</translation>
    </message>
    <message>
        <source>What may be changed while the lesson runs</source>
        <translation>Was geändert werden darf, während die Lektion läuft</translation>
    </message>
    <message>
        <source>Time: %1</source>
        <translation>Zeit: %1</translation>
    </message>
    <message>
        <source>Time left: %1</source>
        <translation>Restzeit: %1</translation>
    </message>
    <message>
        <source>Over the time limit by %1</source>
        <translation>%1 über der Zeitgrenze</translation>
    </message>
    <message>
        <source>Demonstration</source>
        <translation>Vorführung</translation>
    </message>
    <message>
        <source>To pass</source>
        <translation>Zum Bestehen</translation>
    </message>
    <message>
        <source>Limits in a test</source>
        <translation>Grenzen im Test</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Away from a right-angled grasp</source>
        <translation>Abweichung vom rechtwinkligen Griff</translation>
    </message>
    <message>
        <source>right</source>
        <translation>richtig</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>noch nie</translation>
    </message>
    <message>
        <source>used</source>
        <translation>benutzt</translation>
    </message>
    <message>
        <source>Between the needle and the perpendicular to the tissue</source>
        <translation>Zwischen der Nadel und der Senkrechten zum Gewebe</translation>
    </message>
    <message>
        <source>Deviation from perpendicular</source>
        <translation>Abweichung von der Senkrechten</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>Faden</translation>
    </message>
    <message>
        <source>Tension of the thread that is drawn</source>
        <translation>Zug des Fadens, der gezogen wird</translation>
    </message>
    <message>
        <source>▲ %1, over %2</source>
        <translation>▲ %1, über %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Rules</source>
        <translation>Regeln</translation>
    </message>
    <message>
        <source>What is asked, and the limits, in place of the plots</source>
        <translation>Was verlangt ist, und die Grenzen, anstelle der Kurven</translation>
    </message>
    <message>
        <source>A test: readings are hidden until it is over.</source>
        <translation>Ein Test: Die Anzeigen sind bis zum Ende verborgen.</translation>
    </message>
    <message>
        <source>Ends every attempt</source>
        <translation>Beendet jeden Versuch</translation>
    </message>
</context>
<context>
    <name>swage::console::NumberBox</name>
    <message>
        <source>“%1” is no value here: as before, %2.</source>
        <translation>„%1“ ist hier kein Wert: wie zuvor, %2.</translation>
    </message>
    <message>
        <source>At most %1, not %2.</source>
        <translation>Höchstens %1, nicht %2.</translation>
    </message>
    <message>
        <source>At least %1, not %2.</source>
        <translation>Mindestens %1, nicht %2.</translation>
    </message>
</context>
<context>
    <name>swage::console::OrderDialog</name>
    <message>
        <source>This test is not open yet</source>
        <translation>Dieser Test ist noch nicht offen</translation>
    </message>
    <message>
        <source>Another lesson comes first</source>
        <translation>Eine andere Lektion kommt zuerst</translation>
    </message>
    <message>
        <source>Its test opens then; practice is free. An instructor may open the test for this one attempt: the attempt keeps the reason, and its result tells it.</source>
        <translation>Danach öffnet sich ihr Test; üben kann man sie schon jetzt. Ausbilder können den Test für diesen einen Versuch öffnen: Der Versuch behält die Begründung, und sein Ergebnis nennt sie.</translation>
    </message>
    <message>
        <source>Practice is free and counts for no course. The lessons build on one another, so the order helps.</source>
        <translation>Eine Übung ist frei und zählt für keinen Kurs. Die Lektionen bauen aufeinander auf, darum hilft die Reihenfolge.</translation>
    </message>
    <message>
        <source>Reason of the instructor</source>
        <translation>Begründung des Ausbilders</translation>
    </message>
    <message>
        <source>Passed at another place</source>
        <translation>Anderswo bestanden</translation>
    </message>
    <message>
        <source>Assessment on a fixed day</source>
        <translation>Prüfung an einem festen Tag</translation>
    </message>
    <message>
        <source>Tried beside an instructor</source>
        <translation>Versuch neben einem Ausbilder</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Open for this attempt</source>
        <translation>Für diesen Versuch öffnen</translation>
    </message>
    <message>
        <source>Practise all the same</source>
        <translation>Trotzdem üben</translation>
    </message>
    <message>
        <source>To “%1”</source>
        <translation>Zu „%1“</translation>
    </message>
</context>
<context>
    <name>swage::console::Pages</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>swage::console::PartDialog</name>
    <message>
        <source>Add an object</source>
        <translation>Objekt hinzufügen</translation>
    </message>
    <message>
        <source>Add a coupling</source>
        <translation>Kopplung hinzufügen</translation>
    </message>
    <message>
        <source>Add a device</source>
        <translation>Gerät hinzufügen</translation>
    </message>
    <message>
        <source>&amp;What</source>
        <translation>&amp;Was</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>Place, %1</source>
        <translation>Ort, %1</translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation>&amp;Ort</translation>
    </message>
    <message>
        <source>Nothing: it stands or moves by itself</source>
        <translation>Nichts: es steht oder bewegt sich von selbst</translation>
    </message>
    <message>
        <source>Led &amp;by</source>
        <translation>Geführt &amp;von</translation>
    </message>
    <message>
        <source>B&amp;etween</source>
        <translation>&amp;Zwischen</translation>
    </message>
    <message>
        <source>a&amp;nd</source>
        <translation>&amp;und</translation>
    </message>
    <message>
        <source>Nothing of that kind is installed.</source>
        <translation>Nichts dieser Art ist installiert.</translation>
    </message>
    <message>
        <source>A part has a name: lower-case letters, digits and _.</source>
        <translation>Ein Teil hat einen Namen: Kleinbuchstaben, Ziffern und _.</translation>
    </message>
    <message>
        <source>There is a part called &quot;%1&quot; already.</source>
        <translation>Es gibt schon ein Teil namens „%1“.</translation>
    </message>
    <message>
        <source>A coupling binds two objects.</source>
        <translation>Eine Kopplung verbindet zwei Objekte.</translation>
    </message>
</context>
<context>
    <name>swage::console::PartsPanel</name>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Object…</source>
        <translation>Objekt…</translation>
    </message>
    <message>
        <source>Coupling…</source>
        <translation>Kopplung…</translation>
    </message>
    <message>
        <source>Device…</source>
        <translation>Gerät…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Its couplings were removed with it: %1.</source>
        <translation>Seine Kopplungen wurden mit entfernt: %1.</translation>
    </message>
</context>
<context>
    <name>swage::console::PeopleEdits</name>
    <message>
        <source>counts again</source>
        <translation>zählt wieder</translation>
    </message>
    <message>
        <source>Void an attempt</source>
        <translation>Versuch für ungültig erklären</translation>
    </message>
    <message>
        <source>Why does it not count?</source>
        <translation>Warum zählt er nicht?</translation>
    </message>
    <message>
        <source>Technical fault</source>
        <translation>Technischer Fehler</translation>
    </message>
    <message>
        <source>Wrong lesson or settings</source>
        <translation>Falsche Lektion oder Einstellungen</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Unterbrochen</translation>
    </message>
    <message>
        <source>Somebody helped</source>
        <translation>Jemand hat geholfen</translation>
    </message>
    <message>
        <source>Whose attempt is it?</source>
        <translation>Wessen Versuch ist es?</translation>
    </message>
    <message>
        <source>Choose a person or type a new name</source>
        <translation>Wählen Sie eine Person oder geben Sie einen neuen Namen ein</translation>
    </message>
</context>
<context>
    <name>swage::console::PeopleFiles</name>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>Saved to: %1</source>
        <translation>Gespeichert unter: %1</translation>
    </message>
    <message>
        <source>Nobody is chosen.</source>
        <translation>Niemand ist gewählt.</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Page (*.pdf)</source>
        <translation>Seite (*.pdf)</translation>
    </message>
    <message>
        <source>It is about %1 alone, one of the %2 people chosen.</source>
        <translation>Er handelt nur von %1, einer der %2 gewählten Personen.</translation>
    </message>
    <message>
        <source>Export a person&apos;s attempts</source>
        <translation>Versuche einer Person exportieren</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation>%1 kann nicht geschrieben werden: %2.</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Alle Lektionen</translation>
    </message>
    <message>
        <source>About which course?</source>
        <translation>Über welchen Kurs?</translation>
    </message>
    <message>
        <source>%1_report.pdf</source>
        <translation>%1_Bericht.pdf</translation>
    </message>
</context>
<context>
    <name>swage::console::PeopleModel</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1, kept as %2</source>
        <translation>%1, geführt als %2</translation>
    </message>
    <message numerus="yes">
        <source>The last %n attempt(s), newest at the right: ✓ passed, ✗ not passed</source>
        <translation>
            <numerusform>Der letzte Versuch: ✓ bestanden, ✗ nicht bestanden</numerusform>
            <numerusform>Die letzten %n Versuche, der neueste rechts: ✓ bestanden, ✗ nicht bestanden</numerusform>
        </translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Last attempts</source>
        <translation>Letzte Versuche</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation>Zuletzt da</translation>
    </message>
    <message>
        <source>How it goes</source>
        <translation>Stand</translation>
    </message>
</context>
<context>
    <name>swage::console::PeoplePage</name>
    <message>
        <source>Add…</source>
        <translation>Neu…</translation>
    </message>
    <message>
        <source>Add a person</source>
        <translation>Person hinzufügen</translation>
    </message>
    <message>
        <source>Paste a list…</source>
        <translation>Liste einfügen…</translation>
    </message>
    <message>
        <source>Add a list of people, with a preview</source>
        <translation>Eine Liste von Personen hinzufügen, mit Vorschau</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>Ändern…</translation>
    </message>
    <message>
        <source>Name, group and hand of the chosen person</source>
        <translation>Name, Gruppe und Hand der gewählten Person</translation>
    </message>
    <message>
        <source>Assign…</source>
        <translation>Zuweisen…</translation>
    </message>
    <message>
        <source>Give the chosen people, or a group, a course</source>
        <translation>Den gewählten Personen oder einer Gruppe einen Kurs geben</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Export…</translation>
    </message>
    <message>
        <source>The chosen person&apos;s attempts as a table, under the code and without the name</source>
        <translation>Die Versuche der gewählten Person als Tabelle, mit dem Code und ohne den Namen</translation>
    </message>
    <message>
        <source>Erase…</source>
        <translation>Löschen…</translation>
    </message>
    <message>
        <source>The chosen person and everything of theirs, for good</source>
        <translation>Die gewählte Person und alles von ihr, endgültig</translation>
    </message>
    <message>
        <source>All groups</source>
        <translation>Alle Gruppen</translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Whose people are listed</source>
        <translation>Wessen Personen aufgeführt werden</translation>
    </message>
    <message>
        <source>Enter shows this person&apos;s attempts</source>
        <translation>Eingabe zeigt die Versuche dieser Person</translation>
    </message>
    <message>
        <source>Run a lesson</source>
        <translation>Lektion ausführen</translation>
    </message>
    <message>
        <source>Add a person…</source>
        <translation>Person hinzufügen…</translation>
    </message>
    <message>
        <source>1 person</source>
        <translation>1 Person</translation>
    </message>
    <message>
        <source>No one here yet. Attempts appear here after the first lesson; without a name they are kept for Guest, and can be given a name later.</source>
        <translation>Noch niemand hier. Versuche erscheinen nach der ersten Lektion; ohne Namen werden sie für den Gast aufgehoben und können später einen Namen bekommen.</translation>
    </message>
    <message>
        <source>Pages about the chosen person and lesson, to print; of several people the one chosen last</source>
        <translation>Seiten über die gewählte Person und Lektion zum Drucken; bei mehreren die zuletzt gewählte</translation>
    </message>
    <message>
        <source>%1 people</source>
        <translation>%1 Personen</translation>
    </message>
    <message>
        <source>%1 of %2 people</source>
        <translation>%1 von %2 Personen</translation>
    </message>
    <message>
        <source>%1, those who need attention first</source>
        <translation>%1, zuerst wer Hilfe braucht</translation>
    </message>
    <message>
        <source>Group…</source>
        <translation>Gruppe…</translation>
    </message>
    <message>
        <source>A page to print with a table of the chosen people, or of all who are listed where only one is chosen: lessons passed, attempts, last score, who needs attention</source>
        <translation>Eine Seite zum Drucken mit einer Tabelle der gewählten Personen, oder aller gezeigten, wo nur eine gewählt ist: bestandene Lektionen, Versuche, letzte Punkte, wer Aufmerksamkeit braucht</translation>
    </message>
    <message>
        <source>Everybody</source>
        <translation>Alle</translation>
    </message>
</context>
<context>
    <name>swage::console::PersonDialog</name>
    <message>
        <source>Add a person</source>
        <translation>Person hinzufügen</translation>
    </message>
    <message>
        <source>Change a person</source>
        <translation>Person ändern</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>none; type a new one</source>
        <translation>keine; geben Sie eine neue ein</translation>
    </message>
    <message>
        <source>Handedness</source>
        <translation>Händigkeit</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>nicht gesagt</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>made by itself</source>
        <translation>wird selbst vergeben</translation>
    </message>
    <message>
        <source>Exports say the code and never the name.</source>
        <translation>Exporte nennen den Code und nie den Namen.</translation>
    </message>
    <message>
        <source>The name stays in this store; everything that leaves it says the code.</source>
        <translation>Der Name bleibt in diesem Speicher; alles, was ihn verlässt, nennt den Code.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>▲ Somebody is called that already. Add what tells the two apart.</source>
        <translation>▲ So heißt schon jemand. Fügen Sie hinzu, was die beiden unterscheidet.</translation>
    </message>
    <message>
        <source>▲ This code is another person&apos;s already. Without one a code is made.</source>
        <translation>▲ Dieser Code gehört schon einer anderen Person. Ohne Angabe wird einer erzeugt.</translation>
    </message>
</context>
<context>
    <name>swage::console::PersonPanel</name>
    <message>
        <source>Progress, attempts</source>
        <translation>Fortschritt, Versuche</translation>
    </message>
    <message>
        <source>Pro&amp;gress</source>
        <translation>Fort&amp;schritt</translation>
    </message>
    <message>
        <source>&amp;Attempts</source>
        <translation>&amp;Versuche</translation>
    </message>
    <message>
        <source>Every judged attempt of the people chosen above (Ctrl or Shift and a click choose several)</source>
        <translation>Jeder gewertete Versuch der oben gewählten Personen (Strg oder Umschalt und ein Klick wählen mehrere)</translation>
    </message>
    <message>
        <source>G&amp;roup</source>
        <translation>&amp;Gruppe</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>Latest attempt, experts&apos; band</source>
        <translation>Letzter Versuch, Band der Experten</translation>
    </message>
    <message>
        <source>Choose a lesson to see its values beside the experts&apos;.</source>
        <translation>Wählen Sie eine Lektion, um ihre Werte neben denen der Experten zu sehen.</translation>
    </message>
    <message>
        <source>No expert has done this lesson. Experts are the people of the group &quot;Experts&quot;; without them the recorded expert&apos;s attempts stand in.</source>
        <translation>Kein Experte hat diese Lektion gemacht. Experten sind die Personen der Gruppe „Experten“ oder „Experts“; ohne sie stehen die Versuche der aufgezeichneten Expertenhand ein.</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Enter or a double click opens the attempt</source>
        <translation>Eingabe oder ein Doppelklick öffnet den Versuch</translation>
    </message>
    <message>
        <source>Review this attempt</source>
        <translation>Diesen Versuch auswerten</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Öffnen...</translation>
    </message>
    <message>
        <source>Look at an attempt that was saved to a file (Ctrl+O)</source>
        <translation>Einen Versuch ansehen, der in eine Datei gespeichert wurde (Strg+O)</translation>
    </message>
    <message>
        <source>Void…</source>
        <translation>Ungültig…</translation>
    </message>
    <message>
        <source>Give to…</source>
        <translation>Geben an…</translation>
    </message>
    <message>
        <source>This attempt is another person&apos;s: a guest&apos;s, or of a name that was mistaken</source>
        <translation>Dieser Versuch gehört jemand anderem: er war der eines Gastes, oder der Name war falsch</translation>
    </message>
    <message>
        <source>Count again</source>
        <translation>Wieder zählen</translation>
    </message>
    <message>
        <source>This attempt counts again (Ctrl+D)</source>
        <translation>Dieser Versuch zählt wieder (Strg+D)</translation>
    </message>
    <message>
        <source>Void this attempt and say why, as after a fault or a wrong lesson: it is kept and counts for nothing (Ctrl+D)</source>
        <translation>Diesen Versuch mit einem Grund ungültig machen, etwa nach einer Störung oder einer falschen Lektion: er bleibt und zählt für nichts (Strg+D)</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Alle Lektionen</translation>
    </message>
    <message>
        <source>These are several lessons. Choose one to see its learning curve.</source>
        <translation>Das sind mehrere Lektionen. Wählen Sie eine, um ihre Lernkurve zu sehen.</translation>
    </message>
    <message>
        <source>%1 of %2 attempts passed</source>
        <translation>%1 von %2 Versuchen bestanden</translation>
    </message>
    <message>
        <source>, %1 more not counted</source>
        <translation>, %1 weitere zählen nicht</translation>
    </message>
    <message>
        <source>Counted is what a person finished. Recorded hands, void attempts and those that were stopped count for nobody.</source>
        <translation>Es zählt, was eine Person zu Ende gebracht hat. Aufgezeichnete Hände, ungültige und abgebrochene Versuche zählen für niemanden.</translation>
    </message>
    <message>
        <source>A row for each person chosen above: Ctrl or Shift and a click choose several, Ctrl+A all.</source>
        <translation>Eine Zeile für jede oben gewählte Person: Strg oder Umschalt und ein Klick wählen mehrere, Strg+A alle.</translation>
    </message>
    <message>
        <source>No attempt that counts yet: there is nothing to see beside the experts&apos; values.</source>
        <translation>Noch kein Versuch, der zählt: es gibt nichts, was neben den Werten der Experten zu sehen wäre.</translation>
    </message>
</context>
<context>
    <name>swage::console::PullDialog</name>
    <message>
        <source>Pull the knot</source>
        <translation>Knoten ziehen</translation>
    </message>
    <message>
        <source>The knot over two pins that are drawn apart</source>
        <translation>Der Knoten über zwei Stiften, die auseinandergezogen werden</translation>
    </message>
    <message>
        <source>Pull &amp;again</source>
        <translation>Noch &amp;einmal ziehen</translation>
    </message>
    <message>
        <source>&amp;Keep as a note</source>
        <translation>Als &amp;Notiz behalten</translation>
    </message>
    <message>
        <source>A note at this moment of the attempt: it is in the list of events and in the report</source>
        <translation>Eine Notiz zu diesem Zeitpunkt des Versuchs: Sie steht in der Liste der Ereignisse und im Bericht</translation>
    </message>
    <message>
        <source>Tension, of the load</source>
        <translation>Spannung, von der Last</translation>
    </message>
    <message>
        <source>&amp;Load</source>
        <translation>&amp;Last</translation>
    </message>
    <message>
        <source>Of the thread on itself: nylon has 0.1 to 0.3</source>
        <translation>Des Fadens auf sich selbst: Nylon hat 0,1 bis 0,3</translation>
    </message>
    <message>
        <source>&amp;Friction</source>
        <translation>&amp;Reibung</translation>
    </message>
    <message>
        <source>The attempt is not changed: a copy of its thread, cut free of the tissue, is laid over two pins, one of which goes away from the other. It has failed when a tenth of a usual loop has slipped through.</source>
        <translation>Der Versuch bleibt unverändert: Eine Kopie seines Fadens, vom Gewebe gelöst, wird über zwei Stifte gelegt, von denen einer sich vom anderen entfernt. Er hält nicht, wenn ein Zehntel einer üblichen Schlinge durchgerutscht ist.</translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>Knot %1 as it is at %2, loop %3</source>
        <translation>Knoten %1, wie er bei %2 ist, Schlinge %3</translation>
    </message>
    <message>
        <source>Tension %1, slip %2</source>
        <translation>Spannung %1, Schlupf %2</translation>
    </message>
    <message>
        <source>✓ It holds.</source>
        <translation>✓ Er hält.</translation>
    </message>
    <message>
        <source>▲ The thread parts.</source>
        <translation>▲ Der Faden reißt.</translation>
    </message>
    <message>
        <source>▲ It gives way.</source>
        <translation>▲ Er gibt nach.</translation>
    </message>
    <message>
        <source>The solver fell short: %1</source>
        <translation>Der Löser kam nicht nach: %1</translation>
    </message>
    <message>
        <source>Knot %1 pulled, friction %L2:</source>
        <translation>Knoten %1 gezogen, Reibung %L2:</translation>
    </message>
    <message>
        <source>%1 holds %2, slip %3</source>
        <translation>%1 hält %2, Schlupf %3</translation>
    </message>
    <message>
        <source>%1 the thread parts at %2, slip %3</source>
        <translation>%1 Faden reißt bei %2, Schlupf %3</translation>
    </message>
    <message>
        <source>%1 gives way at %2, slip %3</source>
        <translation>%1 gibt nach bei %2, Schlupf %3</translation>
    </message>
    <message>
        <source>▲ The note was not kept.</source>
        <translation>▲ Die Notiz wurde nicht behalten.</translation>
    </message>
    <message>
        <source>Kept as a note.</source>
        <translation>Als Notiz behalten.</translation>
    </message>
    <message>
        <source>Being pulled …</source>
        <translation>Wird gezogen …</translation>
    </message>
</context>
<context>
    <name>swage::console::RatingPanel</name>
    <message>
        <source>Rating scales of surgeons</source>
        <translation>Skalen der Chirurgen</translation>
    </message>
    <message>
        <source>Computed</source>
        <translation>Berechnet</translation>
    </message>
    <message>
        <source>Your rating</source>
        <translation>Ihr Urteil</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Quelle: %1</translation>
    </message>
    <message>
        <source>Your rating: %1</source>
        <translation>Ihr Urteil: %1</translation>
    </message>
    <message>
        <source>not decided</source>
        <translation>nicht entschieden</translation>
    </message>
    <message>
        <source>Your own points; kept with the attempt, and taken back with Ctrl+Z</source>
        <translation>Ihre eigenen Punkte; beim Versuch aufbewahrt, mit Strg+Z zurückgenommen</translation>
    </message>
    <message>
        <source>Ratings are kept with attempts of the store.</source>
        <translation>Urteile werden bei Versuchen des Speichers aufbewahrt.</translation>
    </message>
</context>
<context>
    <name>swage::console::ResultPanel</name>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Points lost</source>
        <translation>Verlorene Punkte</translation>
    </message>
    <message>
        <source>All numbers</source>
        <translation>Alle Zahlen</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Next lesson</source>
        <translation>Nächste Lektion</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Stopped before the lesson was over.</source>
        <translation>Beendet, bevor die Lektion vorbei war.</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>▲ Not recorded: nothing of this attempt is kept.</source>
        <translation>▲ Nicht aufgezeichnet: von diesem Versuch bleibt nichts.</translation>
    </message>
    <message>
        <source>Not recorded.</source>
        <translation>Nicht aufgezeichnet.</translation>
    </message>
    <message>
        <source>▲ Recorded beside the store, until it can be written again.</source>
        <translation>▲ Neben dem Speicher aufgezeichnet, bis er wieder beschrieben werden kann.</translation>
    </message>
    <message>
        <source>▲ Recorded, but %1 steps are missing.</source>
        <translation>▲ Aufgezeichnet, doch %1 Schritte fehlen.</translation>
    </message>
    <message>
        <source>Recorded as an attempt of a recorded hand; it counts for nobody.</source>
        <translation>Als Versuch einer aufgezeichneten Hand behalten; er zählt für niemanden.</translation>
    </message>
    <message>
        <source>Recorded.</source>
        <translation>Aufgezeichnet.</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Gesehen</translation>
    </message>
    <message>
        <source>A demonstration: nothing was judged or recorded.</source>
        <translation>Eine Vorführung: nichts wurde gewertet oder aufgezeichnet.</translation>
    </message>
    <message>
        <source>To pass</source>
        <translation>Zum Bestehen</translation>
    </message>
    <message>
        <source>Limits in a test</source>
        <translation>Grenzen im Test</translation>
    </message>
    <message>
        <source>%1: %2 active, %3 free</source>
        <translation>%1: %2 aktiv, %3 frei</translation>
    </message>
    <message>
        <source>The readings were open on the trainee&apos;s screen.</source>
        <translation>Die Anzeigen waren auf dem Bildschirm des Trainees offen.</translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>▲ %1, over %2</source>
        <translation>▲ %1, über %2</translation>
    </message>
    <message>
        <source>Ends every attempt</source>
        <translation>Beendet jeden Versuch</translation>
    </message>
</context>
<context>
    <name>swage::console::ReviewPage</name>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Choose an attempt on the People page and press Enter, or open one that was saved to a file (Ctrl+O).</source>
        <translation>Wählen Sie auf der Seite Personen einen Versuch und drücken Sie die Eingabetaste, oder öffnen Sie einen, der in eine Datei gespeichert wurde (Strg+O).</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Next worst moment</source>
        <translation>Nächster schlechtester Moment</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>Vergleich beenden</translation>
    </message>
    <message>
        <source>‹ People</source>
        <translation>‹ Personen</translation>
    </message>
    <message>
        <source>Note…</source>
        <translation>Notiz…</translation>
    </message>
    <message>
        <source>Write a note at the cursor (N)</source>
        <translation>Eine Notiz an der Marke schreiben (N)</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>Vergleichen…</translation>
    </message>
    <message>
        <source>Another attempt at this lesson beside it, on the same clock (C)</source>
        <translation>Ein anderer Versuch dieser Lektion daneben, nach derselben Uhr (C)</translation>
    </message>
    <message>
        <source>The picture cannot be replayed: %1 Traces, events and metrics are as recorded.</source>
        <translation>Das Bild kann nicht nachgespielt werden: %1 Kurven, Ereignisse und Kennzahlen sind wie aufgezeichnet.</translation>
    </message>
    <message>
        <source>From %L1 s on the picture is not the attempt bit for bit: it was recorded with another version of a plugin. Traces, events and metrics are as recorded.</source>
        <translation>Ab %L1 s ist das Bild nicht Bit für Bit der Versuch: er wurde mit einer anderen Version eines Plugins aufgezeichnet. Kurven, Ereignisse und Kennzahlen sind wie aufgezeichnet.</translation>
    </message>
    <message>
        <source>At %L1 s:</source>
        <translation>Bei %L1 s:</translation>
    </message>
    <message>
        <source>▲ The note was not kept: %1</source>
        <translation>▲ Die Notiz wurde nicht behalten: %1</translation>
    </message>
    <message>
        <source>Ghost</source>
        <translation>Durchscheinend</translation>
    </message>
    <message>
        <source>Choose an attempt</source>
        <translation>Versuch wählen</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Datei öffnen…</translation>
    </message>
    <message>
        <source>Next event</source>
        <translation>Nächstes Ereignis</translation>
    </message>
    <message>
        <source>Event before</source>
        <translation>Voriges Ereignis</translation>
    </message>
    <message>
        <source>▲ The rating was not kept: %1</source>
        <translation>▲ Das Urteil wurde nicht aufbewahrt: %1</translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>Pull the knot</source>
        <translation>Knoten ziehen</translation>
    </message>
    <message>
        <source>Pull the knot…</source>
        <translation>Knoten ziehen…</translation>
    </message>
    <message>
        <source>Does the knot hold, as it is at the cursor? A copy of it is pulled (K)</source>
        <translation>Hält der Knoten, wie er am Cursor ist? Eine Kopie davon wird gezogen (K)</translation>
    </message>
    <message>
        <source>This attempt has no knot.</source>
        <translation>Dieser Versuch hat keinen Knoten.</translation>
    </message>
    <message>
        <source>▲ At %1: %2 Go to where it is tied, such as the end.</source>
        <translation>▲ Bei %1: %2 Dorthin gehen, wo er geknüpft ist, etwa ans Ende.</translation>
    </message>
    <message>
        <source>The knot is pulled as soon as the picture is at the cursor.</source>
        <translation>Der Knoten wird gezogen, sobald das Bild am Cursor ist.</translation>
    </message>
</context>
<context>
    <name>swage::console::ReviewPictures</name>
    <message>
        <source>The attempt, replayed</source>
        <translation>Der Versuch, nachgespielt</translation>
    </message>
    <message>
        <source>Replay: %1</source>
        <translation>Wiedergabe: %1</translation>
    </message>
</context>
<context>
    <name>swage::console::ReviewSide</name>
    <message>
        <source>Metrics, events, traces</source>
        <translation>Kennzahlen, Ereignisse, Kurven</translation>
    </message>
    <message>
        <source>&amp;Metrics</source>
        <translation>&amp;Kennzahlen</translation>
    </message>
    <message>
        <source>&amp;Worst</source>
        <translation>S&amp;chlechteste</translation>
    </message>
    <message>
        <source>Worst moments</source>
        <translation>Schlechteste Momente</translation>
    </message>
    <message>
        <source>&amp;Events</source>
        <translation>&amp;Ereignisse</translation>
    </message>
    <message>
        <source>&amp;Traces</source>
        <translation>K&amp;urven</translation>
    </message>
    <message>
        <source>E&amp;ntry</source>
        <translation>E&amp;instich</translation>
    </message>
    <message>
        <source>&amp;Scales</source>
        <translation>&amp;Skalen</translation>
    </message>
    <message>
        <source>Rating scales of surgeons: as computed from metrics, and your own rating</source>
        <translation>Skalen der Chirurgen: aus Kennzahlen berechnet, und Ihr eigenes Urteil</translation>
    </message>
</context>
<context>
    <name>swage::console::ReviewTransport</name>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>To the start (Home)</source>
        <translation>Zum Anfang (Pos1)</translation>
    </message>
    <message>
        <source>10 ms back (←; with Shift 1 ms, with Ctrl 1 s)</source>
        <translation>10 ms zurück (←; mit Umschalt 1 ms, mit Strg 1 s)</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play, pause (Space)</source>
        <translation>Abspielen, Pause (Leertaste)</translation>
    </message>
    <message>
        <source>10 ms on (→; with Shift 1 ms, with Ctrl 1 s)</source>
        <translation>10 ms vor (→; mit Umschalt 1 ms, mit Strg 1 s)</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>Play a second before and after the cursor again and again (L)</source>
        <translation>Je eine Sekunde vor und nach der Marke immer wieder abspielen (L)</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Kreisen</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>Nah</translation>
    </message>
    <message>
        <source>%1 view</source>
        <translation>Ansicht: %1</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Kräfte</translation>
    </message>
    <message>
        <source>Show contact forces in the picture</source>
        <translation>Kontaktkräfte im Bild zeigen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
</context>
<context>
    <name>swage::console::RosterDialog</name>
    <message>
        <source>Add a list of people</source>
        <translation>Liste von Personen hinzufügen</translation>
    </message>
    <message>
        <source>Paste a name per line, or columns name, group, hand, code out of a table. A first line with these words says their order.</source>
        <translation>Fügen Sie einen Namen je Zeile ein, oder Spalten Name, Gruppe, Hand, Code aus einer Tabelle. Eine erste Zeile mit den Wörtern name, group, hand, code sagt ihre Reihenfolge.</translation>
    </message>
    <message>
        <source>List of people</source>
        <translation>Liste der Personen</translation>
    </message>
    <message>
        <source>Arun P.
Bea L., Spring, left</source>
        <translation>Arun P.
Bea L., Frühjahr, links</translation>
    </message>
    <message>
        <source>What will be added</source>
        <translation>Was hinzugefügt wird</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Datei öffnen…</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>A list of people</source>
        <translation>Eine Liste von Personen</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt *.tsv);;All files (*)</source>
        <translation>Tabellen (*.csv *.txt *.tsv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>▲ %1 cannot be read: %2.</source>
        <translation>▲ %1 kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>+ new</source>
        <translation>+ neu</translation>
    </message>
    <message>
        <source>%1 of %2 lines are left out; the preview says why.</source>
        <translation>%1 von %2 Zeilen bleiben weg; die Vorschau sagt, warum.</translation>
    </message>
    <message>
        <source>Add 1 person</source>
        <translation>1 Person hinzufügen</translation>
    </message>
    <message>
        <source>Add %1 people</source>
        <translation>%1 Personen hinzufügen</translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>▲ Columns that are left out: %1.</source>
        <translation>▲ Nicht übernommene Spalten: %1.</translation>
    </message>
</context>
<context>
    <name>swage::console::RulePanel</name>
    <message>
        <source>Pass rule</source>
        <translation>Bestehensregel</translation>
    </message>
    <message>
        <source>Kind of rule</source>
        <translation>Art der Regel</translation>
    </message>
    <message>
        <source>in a row</source>
        <translation>in Folge</translation>
    </message>
    <message>
        <source>learning-curve test (strict)</source>
        <translation>Lernkurventest (streng)</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>Test attempts in a row</source>
        <translation>Testversuche in Folge</translation>
    </message>
    <message>
        <source>Test attempts in a row that meet everything that is asked</source>
        <translation>Testversuche nacheinander, die alles Geforderte erfüllen</translation>
    </message>
    <message>
        <source>then, first of a later day</source>
        <translation>dann die ersten an späterem Tag</translation>
    </message>
    <message>
        <source>First attempts of a later day that must meet it, too; 0: none</source>
        <translation>Erste Versuche eines späteren Tages, die es auch erfüllen müssen; 0: keine</translation>
    </message>
    <message>
        <source>Failure rate, competent</source>
        <translation>Fehlerrate, wer es kann</translation>
    </message>
    <message>
        <source>Share of attempts that a competent person fails</source>
        <translation>Anteil der Versuche, die einer geübten Person misslingen</translation>
    </message>
    <message>
        <source>Failure rate, not yet</source>
        <translation>Fehlerrate, noch nicht</translation>
    </message>
    <message>
        <source>Share of attempts that a person fails who is not competent yet</source>
        <translation>Anteil der Versuche, die einer ungeübten Person misslingen</translation>
    </message>
    <message>
        <source>Signal at</source>
        <translation>Meldung bei</translation>
    </message>
    <message>
        <source>Lower passes the unready, higher takes longer; 2.4 is usual</source>
        <translation>Kleiner lässt Ungeübte durch, größer dauert länger; üblich ist 2,4</translation>
    </message>
    <message>
        <source>Attempts a day that count</source>
        <translation>Versuche am Tag, die zählen</translation>
    </message>
    <message>
        <source>0: all</source>
        <translation>0: alle</translation>
    </message>
    <message>
        <source>Warm-up attempts a day</source>
        <translation>Aufwärmversuche am Tag</translation>
    </message>
    <message>
        <source>That do not count</source>
        <translation>Die nicht zählen</translation>
    </message>
    <message>
        <source>What this rule does in 30 attempts</source>
        <translation>Was diese Regel in 30 Versuchen bewirkt</translation>
    </message>
</context>
<context>
    <name>swage::console::RulerBar</name>
    <message>
        <source>A bar of 100 mm, to hold a ruler to</source>
        <translation>Ein Balken von 100 mm, um ein Lineal anzulegen</translation>
    </message>
    <message>
        <source>The size of the screen is not known yet.</source>
        <translation>Die Größe des Bildschirms ist noch nicht bekannt.</translation>
    </message>
    <message>
        <source>100 mm: hold a ruler to it</source>
        <translation>100 mm: legen Sie ein Lineal an</translation>
    </message>
</context>
<context>
    <name>swage::console::RunControl</name>
    <message>
        <source>Nothing runs.</source>
        <translation>Nichts läuft.</translation>
    </message>
    <message>
        <source>It was refused.</source>
        <translation>Es wurde abgelehnt.</translation>
    </message>
</context>
<context>
    <name>swage::console::RunPage</name>
    <message>
        <source>What happened in this attempt</source>
        <translation>Was in diesem Versuch geschah</translation>
    </message>
    <message>
        <source>New trainee</source>
        <translation>Neuer Trainee</translation>
    </message>
    <message>
        <source>%1 has not practised here before. Add as a trainee?</source>
        <translation>%1 hat hier noch nicht geübt. Als Trainee aufnehmen?</translation>
    </message>
    <message>
        <source>Add and start</source>
        <translation>Aufnehmen und beginnen</translation>
    </message>
    <message>
        <source>○ Ready</source>
        <translation>○ Bereit</translation>
    </message>
    <message>
        <source>○ No lessons</source>
        <translation>○ Keine Lektionen</translation>
    </message>
    <message>
        <source>In the course: %1.</source>
        <translation>Im Kurs: %1.</translation>
    </message>
    <message>
        <source>An attempt runs: Shift+F5 stops it, and then F5 begins anew.</source>
        <translation>Ein Versuch läuft: Umschalt+F5 beendet ihn, danach beginnt F5 neu.</translation>
    </message>
    <message>
        <source>Opened before its turn in the course: %1.</source>
        <translation>Im Kurs vor der Reihe geöffnet: %1.</translation>
    </message>
</context>
<context>
    <name>swage::console::SceneInput</name>
    <message>
        <source>The instrument waits: a drag turns the view</source>
        <translation>Das Instrument wartet: Ziehen dreht die Ansicht</translation>
    </message>
    <message>
        <source>Click here: then mouse and keys move the instrument</source>
        <translation>Klicken Sie hier: dann bewegen Maus und Tasten das Instrument</translation>
    </message>
    <message>
        <source>Tab: the other instrument</source>
        <translation>Tab: das andere Instrument</translation>
    </message>
    <message>
        <source>Drag, wheel: move the instrument; keys A D: sideways, W S: up and down, Q E: away and near</source>
        <translation>Ziehen, Rad: das Instrument bewegen; Tasten A D: seitwärts, W S: auf und ab, Q E: weg und her</translation>
    </message>
    <message>
        <source>Hold Space: close the jaws, B: open them</source>
        <translation>Leertaste halten: die Backen schließen, B: öffnen</translation>
    </message>
    <message>
        <source>Hold T: drive the needle, once its point stands square to the tissue</source>
        <translation>T halten: die Nadel führen, sobald ihre Spitze senkrecht zum Gewebe steht</translation>
    </message>
    <message>
        <source>F7: put it back</source>
        <translation>F7: zurücklegen</translation>
    </message>
    <message>
        <source>Hold B: open the jaws</source>
        <translation>B halten: Backen öffnen</translation>
    </message>
    <message>
        <source>No bent needle is at the tips that could be driven</source>
        <translation>An den Spitzen ist keine gebogene Nadel, die man führen könnte</translation>
    </message>
    <message>
        <source>F11: look from the side, where keys go along the needle</source>
        <translation>F11: von der Seite sehen, wo die Tasten der Nadel folgen</translation>
    </message>
    <message>
        <source>F11, %1 times: look from the side, where keys go along the needle</source>
        <translation>F11, %1-mal: von der Seite sehen, wo die Tasten der Nadel folgen</translation>
    </message>
</context>
<context>
    <name>swage::console::SceneView</name>
    <message>
        <source>Live view of the scene</source>
        <translation>Die Szene, wie sie jetzt ist</translation>
    </message>
</context>
<context>
    <name>swage::console::SchoolDesk</name>
    <message>
        <source>Nothing is kept: the program was started without a store.</source>
        <translation>Nichts wird behalten: das Programm wurde ohne Speicher gestartet.</translation>
    </message>
    <message numerus="yes">
        <source>Add %n people</source>
        <translation>
            <numerusform>%n Person hinzufügen</numerusform>
            <numerusform>%n Personen hinzufügen</numerusform>
        </translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Void an attempt</source>
        <translation>Versuch für ungültig erklären</translation>
    </message>
    <message>
        <source>Count an attempt</source>
        <translation>Versuch zählen</translation>
    </message>
    <message>
        <source>Give an attempt to a person</source>
        <translation>Versuch jemandem geben</translation>
    </message>
    <message>
        <source>Assign a course</source>
        <translation>Kurs zuweisen</translation>
    </message>
    <message>
        <source>Add a note</source>
        <translation>Notiz hinzufügen</translation>
    </message>
    <message>
        <source>Remove a note</source>
        <translation>Notiz entfernen</translation>
    </message>
    <message>
        <source>Rate an item</source>
        <translation>Ein Kriterium beurteilen</translation>
    </message>
</context>
<context>
    <name>swage::console::SetupPage</name>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Trainee&apos;s view</source>
        <translation>Ansicht des Trainees</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>Colours of the window</source>
        <translation>Farben des Fensters</translation>
    </message>
    <message>
        <source>Cue colours</source>
        <translation>Hinweisfarben</translation>
    </message>
    <message>
        <source>Colours of the cues; shapes, words and sounds stay the same</source>
        <translation>Farben der Hinweise; Formen, Wörter und Töne bleiben gleich</translation>
    </message>
    <message>
        <source>The scene for two eyes, in a window of its own for the trainee&apos;s screen.</source>
        <translation>Die Szene für zwei Augen, in einem eigenen Fenster für den Bildschirm des Trainees.</translation>
    </message>
    <message>
        <source>Open, close</source>
        <translation>Öffnen, schließen</translation>
    </message>
    <message>
        <source>Screen, layout, eyes…</source>
        <translation>Bildschirm, Anordnung, Augen…</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>Instrument</translation>
    </message>
    <message>
        <source>Jaw sensors</source>
        <translation>Backensensoren</translation>
    </message>
    <message>
        <source>10 mm shown as 10 mm, and hand and tool in one place: by a ruler, and with an arm at four marks.</source>
        <translation>10 mm als 10 mm gezeigt, und Hand und Werkzeug am selben Ort: mit einem Lineal, und mit einem Arm an vier Marken.</translation>
    </message>
    <message>
        <source>True size and place…</source>
        <translation>Wahre Größe und Ort…</translation>
    </message>
    <message>
        <source>Pose from</source>
        <translation>Lage von</translation>
    </message>
    <message>
        <source>The device that says where the instrument is</source>
        <translation>Das Gerät, das sagt, wo das Instrument ist</translation>
    </message>
    <message>
        <source>Jaws from</source>
        <translation>Backen von</translation>
    </message>
    <message>
        <source>The device that says how far the jaws are closed, and how hard</source>
        <translation>Das Gerät, das sagt, wie weit die Backen geschlossen sind und wie fest</translation>
    </message>
    <message>
        <source>Clutch</source>
        <translation>Kupplung</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Button %1</source>
        <translation>Taste %1</translation>
    </message>
    <message>
        <source>A pedal that sends the keys F5, F6 and F7 starts, pauses and puts back without letting go of the instrument.</source>
        <translation>Ein Pedal, das die Tasten F5, F6 und F7 sendet, startet, hält an und legt zurück, ohne dass die Hand das Instrument loslässt.</translation>
    </message>
    <message>
        <source>As the lesson says</source>
        <translation>Wie die Lektion sagt</translation>
    </message>
    <message>
        <source>The same device</source>
        <translation>Dasselbe Gerät</translation>
    </message>
    <message>
        <source>Of %1, at this computer</source>
        <translation>Von %1, an diesem Rechner</translation>
    </message>
    <message>
        <source>Calibrate…</source>
        <translation>Kalibrieren…</translation>
    </message>
    <message>
        <source>What the volts of a sensor in a needleholder&apos;s handle mean: thirteen lengths on a bench, and three poses</source>
        <translation>Was die Spannung eines Sensors im Griff eines Nadelhalters bedeutet: dreizehn Längen auf einer Messbank und drei Stellungen</translation>
    </message>
    <message>
        <source>No sensor is calibrated on this computer.</source>
        <translation>An diesem Rechner ist kein Sensor kalibriert.</translation>
    </message>
    <message>
        <source>While this button or pedal is down the tool stands still; afterwards it goes on from there</source>
        <translation>Solange dieser Knopf oder dieses Pedal gedrückt ist, steht das Instrument still; danach geht es von dort weiter</translation>
    </message>
    <message>
        <source>Clutch of</source>
        <translation>Kupplung an</translation>
    </message>
    <message>
        <source>The device whose button or pedal that is</source>
        <translation>Das Gerät, dessen Knopf oder Pedal das ist</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>What the window is written in, from the next start on</source>
        <translation>Sprache des Fensters, ab dem nächsten Start</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>From the next start on.</source>
        <translation>Ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>This station</source>
        <translation>Dieser Platz</translation>
    </message>
    <message>
        <source>Station: %1</source>
        <translation>Platz: %1</translation>
    </message>
    <message>
        <source>No store: nothing is kept.</source>
        <translation>Kein Speicher: nichts wird aufbewahrt.</translation>
    </message>
    <message>
        <source>Store: %1</source>
        <translation>Speicher: %1</translation>
    </message>
</context>
<context>
    <name>swage::console::SetupPanel</name>
    <message>
        <source>START</source>
        <translation>START</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>Trainee</translation>
    </message>
    <message>
        <source>Guest</source>
        <translation>Gast</translation>
    </message>
    <message>
        <source>Choose a name or type a new one. Without a name the attempt is kept for Guest.</source>
        <translation>Wählen Sie einen Namen oder geben Sie einen neuen ein. Ohne Namen wird der Versuch für den Gast behalten.</translation>
    </message>
    <message>
        <source>Left-handed</source>
        <translation>Linkshändig</translation>
    </message>
    <message>
        <source>Mirrors the whole lesson, hand and picture; kept with the attempt</source>
        <translation>Spiegelt die ganze Lektion, Hand und Bild; wird mit dem Versuch behalten</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>No lessons found. Put lesson files into ~/.local/share/swage/lessons, or name one when starting the program: swage-console lesson.json</source>
        <translation>Keine Lektionen gefunden. Legen Sie Lektionsdateien in ~/.local/share/swage/lessons, oder nennen Sie beim Start eine: swage-console lesson.json</translation>
    </message>
    <message>
        <source>New lesson from this…</source>
        <translation>Neue Lektion hieraus…</translation>
    </message>
    <message>
        <source>A lesson of your own, based on the chosen one: another needle, stiffer tissue, a stricter limit</source>
        <translation>Eine eigene Lektion nach der gewählten: eine andere Nadel, steiferes Gewebe, eine strengere Grenze</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Bearbeiten…</translation>
    </message>
    <message>
        <source>Title, task, goal and values of this lesson of your own</source>
        <translation>Titel, Aufgabe, Ziel und Werte dieser eigenen Lektion</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Löschen…</translation>
    </message>
    <message>
        <source>Put this lesson of your own into the bin; attempts at it stay</source>
        <translation>Diese eigene Lektion in den Papierkorb legen; Versuche daran bleiben</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>Cues and readings are hidden; limits end the attempt, and it counts.</source>
        <translation>Hinweise und Anzeigen bleiben verborgen; Grenzen beenden den Versuch, und er zählt.</translation>
    </message>
    <message>
        <source>Demo</source>
        <translation>Demo</translation>
    </message>
    <message>
        <source>Watch the expert&apos;s hand. Nothing is recorded.</source>
        <translation>Sehen Sie der Hand des Experten zu. Nichts wird aufgezeichnet.</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>Instrument</translation>
    </message>
    <message>
        <source>Mouse and keyboard</source>
        <translation>Maus und Tastatur</translation>
    </message>
    <message>
        <source>Recorded hand: %1</source>
        <translation>Aufgezeichnete Hand: %1</translation>
    </message>
    <message>
        <source>A demonstration: nothing is judged or recorded.</source>
        <translation>Eine Vorführung: nichts wird gewertet oder aufgezeichnet.</translation>
    </message>
    <message>
        <source>This lesson cannot run; the picture says why.</source>
        <translation>Diese Lektion kann nicht ausgeführt werden; das Bild sagt, warum.</translation>
    </message>
    <message>
        <source>START   F5</source>
        <translation>START   F5</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Running…</source>
        <translation>Läuft…</translation>
    </message>
    <message>
        <source>Cues and readings are hidden, and limits end the attempt. A recorded hand&apos;s attempt counts for nobody.</source>
        <translation>Hinweise und Messwerte sind verborgen, und Grenzen beenden den Versuch. Der Versuch einer aufgezeichneten Hand zählt für niemanden.</translation>
    </message>
    <message>
        <source>To that lesson</source>
        <translation>Zu dieser Lektion</translation>
    </message>
    <message>
        <source>Chooses the next lesson of the course, in Test: only tests count there</source>
        <translation>Wählt die nächste Lektion des Kurses, als Test: Dort zählen nur Tests</translation>
    </message>
    <message>
        <source>▲ Chosen lesson: not open yet</source>
        <translation>▲ Gewählte Lektion: noch nicht offen</translation>
    </message>
    <message>
        <source>Cues are shown. Limits of a test are told and end nothing; a recorded hand is judged as in a test.</source>
        <translation>Hinweise werden gezeigt. Grenzen eines Tests werden genannt und beenden nichts; eine aufgezeichnete Hand wird wie im Test beurteilt.</translation>
    </message>
</context>
<context>
    <name>swage::console::SoundControl</name>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Let the cues be heard</source>
        <translation>Die Hinweise hören lassen</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Lautstärke</translation>
    </message>
    <message>
        <source>Volume of the cues</source>
        <translation>Lautstärke der Hinweise</translation>
    </message>
    <message>
        <source>No sound device answers (%1). Cues are seen, not heard.</source>
        <translation>Kein Tongerät antwortet (%1). Hinweise werden gesehen, nicht gehört.</translation>
    </message>
</context>
<context>
    <name>swage::console::StationDialog</name>
    <message>
        <source>True size and place</source>
        <translation>Wahre Größe und Ort</translation>
    </message>
    <message>
        <source>By a ruler</source>
        <translation>Mit einem Lineal</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Screen &amp;width</source>
        <translation>Bildschirm&amp;breite</translation>
    </message>
    <message>
        <source>Width of the part that lights up, along its lower edge</source>
        <translation>Breite der leuchtenden Fläche, entlang ihrer unteren Kante</translation>
    </message>
    <message>
        <source>Screen &amp;height</source>
        <translation>Bildschirm&amp;höhe</translation>
    </message>
    <message>
        <source>Height of the part that lights up, along its left edge</source>
        <translation>Höhe der leuchtenden Fläche, entlang ihrer linken Kante</translation>
    </message>
    <message>
        <source>&amp;Eyes to picture</source>
        <translation>A&amp;ugen bis Bild</translation>
    </message>
    <message>
        <source>From the eyes to the mirror and on to the screen</source>
        <translation>Von den Augen zum Spiegel und weiter zum Bildschirm</translation>
    </message>
    <message>
        <source>From the eyes to the screen</source>
        <translation>Von den Augen zum Bildschirm</translation>
    </message>
    <message>
        <source>Between the &amp;pupils</source>
        <translation>Zwischen den &amp;Pupillen</translation>
    </message>
    <message>
        <source>63 mm is usual; 0 shows one picture to both eyes</source>
        <translation>63 mm sind üblich; 0 zeigt beiden Augen ein Bild</translation>
    </message>
    <message>
        <source>&amp;Tilt of the screen</source>
        <translation>&amp;Neigung des Bildschirms</translation>
    </message>
    <message>
        <source>From the table: 90 stands upright, 0 lies with its face up, -45 looks down onto a mirror</source>
        <translation>Gegen den Tisch: 90 steht aufrecht, 0 liegt mit dem Bild nach oben, -45 sieht auf einen Spiegel herab</translation>
    </message>
    <message>
        <source>Tilt of the m&amp;irror</source>
        <translation>Neigung des Sp&amp;iegels</translation>
    </message>
    <message>
        <source>From the table; counts where the trainee&apos;s view is mirrored</source>
        <translation>Gegen den Tisch; zählt, wo die Ansicht des Trainees gespiegelt ist</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>&amp;Maßstab</translation>
    </message>
    <message>
        <source>×</source>
        <translation>×</translation>
    </message>
    <message>
        <source>1 shows 10 mm as 10 mm; a microscope enlarges 4 to 25 times</source>
        <translation>1 zeigt 10 mm als 10 mm; ein Mikroskop vergrößert 4- bis 25-fach</translation>
    </message>
    <message>
        <source>Show the trainee&apos;s view in this size</source>
        <translation>Die Ansicht des Trainees in dieser Größe zeigen</translation>
    </message>
    <message>
        <source>Turn it until the picture stands upright for the person</source>
        <translation>Drehen, bis das Bild für die Person aufrecht steht</translation>
    </message>
    <message>
        <source>Nobody turns the view then; needed for hand and tool in one place</source>
        <translation>Dann dreht niemand die Ansicht; nötig für Hand und Werkzeug am selben Ort</translation>
    </message>
    <message>
        <source>Hand and tool in one place</source>
        <translation>Hand und Werkzeug am selben Ort</translation>
    </message>
    <message>
        <source>Register…</source>
        <translation>Einmessen…</translation>
    </message>
    <message>
        <source>Tip is at the mark</source>
        <translation>Spitze ist an der Marke</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Vergessen</translation>
    </message>
    <message>
        <source>One pixel is %1 mm; 10 mm of the scene are %2 mm on the screen.</source>
        <translation>Ein Bildpunkt ist %1 mm; 10 mm der Szene sind %2 mm auf dem Bildschirm.</translation>
    </message>
    <message>
        <source>Measure width and height of the screen first.</source>
        <translation>Messen Sie zuerst Breite und Höhe des Bildschirms.</translation>
    </message>
    <message>
        <source>An attempt runs, or no lesson is chosen on the Run page.</source>
        <translation>Ein Versuch läuft, oder auf der Seite Üben ist keine Lektion gewählt.</translation>
    </message>
    <message>
        <source> Nothing is kept.</source>
        <translation> Nichts wird behalten.</translation>
    </message>
    <message>
        <source>Begin again</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>upper left</source>
        <translation>oben links</translation>
    </message>
    <message>
        <source>upper right</source>
        <translation>oben rechts</translation>
    </message>
    <message>
        <source>lower right</source>
        <translation>unten rechts</translation>
    </message>
    <message>
        <source>lower left</source>
        <translation>unten links</translation>
    </message>
    <message>
        <source>Mark %1 of 4, %2: lead the tip to it and hold still.</source>
        <translation>Marke %1 von 4, %2: führen Sie die Spitze hin und halten Sie still.</translation>
    </message>
    <message>
        <source>%1 is not registered: the arm&apos;s tip is led to four marks of the trainee&apos;s view, and its place is known then.</source>
        <translation>%1 ist nicht eingemessen: die Spitze des Arms wird zu vier Marken in der Ansicht des Trainees geführt, dann ist sein Ort bekannt.</translation>
    </message>
    <message>
        <source>The instrument</source>
        <translation>Das Instrument</translation>
    </message>
    <message>
        <source>Registered on %1, worst mark %2 mm off, rms %3 mm.</source>
        <translation>Eingemessen am %1, schlechteste Marke %2 mm daneben, Effektivwert %3 mm.</translation>
    </message>
    <message>
        <source> It is that of %1, and not used for %2.</source>
        <translation> Es gilt für %1 und wird für %2 nicht benutzt.</translation>
    </message>
</context>
<context>
    <name>swage::console::StationMessages</name>
    <message>
        <source>%1   (F3: read)</source>
        <translation>%1   (F3: gelesen)</translation>
    </message>
</context>
<context>
    <name>swage::console::StationsModel</name>
    <message>
        <source>%1 (here)</source>
        <translation>%1 (hier)</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Cues</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Health</source>
        <translation>Technik</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>Trainee</translation>
    </message>
</context>
<context>
    <name>swage::console::StationsPage</name>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>✓ Marked at %1 of the attempt at %2</source>
        <translation>✓ Markiert bei %1 des Versuchs an %2</translation>
    </message>
    <message>
        <source>Picture of now</source>
        <translation>Bild von jetzt</translation>
    </message>
    <message>
        <source>Picture of %1 s ago</source>
        <translation>Bild von vor %1 s</translation>
    </message>
    <message>
        <source>Stations</source>
        <translation>Plätze</translation>
    </message>
    <message>
        <source>Enter: write to this station</source>
        <translation>Eingabetaste: diesem Platz schreiben</translation>
    </message>
    <message>
        <source>Said from here</source>
        <translation>Von hier gesagt</translation>
    </message>
    <message>
        <source>Messages and lessons that were sent from here, with their receipts</source>
        <translation>Nachrichten und Lektionen, die von hier gesendet wurden, mit Quittungen</translation>
    </message>
    <message>
        <source>Picture of the scene at this station</source>
        <translation>Bild der Szene an diesem Platz</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>Aus der Liste nehmen</translation>
    </message>
    <message>
        <source>For a station that is gone; it comes back by itself when it is started again</source>
        <translation>Für einen Platz, den es nicht mehr gibt; er kommt von selbst wieder, wenn er gestartet wird</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Words for this station</source>
        <translation>Worte für diesen Platz</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Senden</translation>
    </message>
    <message>
        <source>Lesson for this station</source>
        <translation>Lektion für diesen Platz</translation>
    </message>
    <message>
        <source>Send lesson</source>
        <translation>Lektion senden</translation>
    </message>
    <message>
        <source>What is to be seen here</source>
        <translation>Was hier zu sehen ist</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Markierung</translation>
    </message>
    <message>
        <source>1 station</source>
        <translation>1 Platz</translation>
    </message>
    <message>
        <source>%1 stations</source>
        <translation>%1 Plätze</translation>
    </message>
    <message>
        <source>▲ What is shown is %1 s old. %2</source>
        <translation>▲ Was zu sehen ist, ist %1 s alt. %2</translation>
    </message>
    <message>
        <source>The attempts of this school are kept in a file, so there is only this station.

To see all stations here, what each trainee does and how it goes, let every station use one PostgreSQL database (package postgresql of Debian). Start each with

    swage-console --store postgresql://user@server/swage?sslmode=verify-full --station &quot;Table 1&quot;

The users of that server decide who may see and say what, and sslmode encrypts it on its way. Nothing else listens on the network, and no lesson ever waits for it.</source>
        <translation>Die Versuche dieser Schule liegen in einer Datei, daher gibt es nur diesen Platz.

Damit hier alle Plätze zu sehen sind, was alle Lernenden tun und wie es geht, müssen alle Plätze eine PostgreSQL-Datenbank benutzen (Paket postgresql von Debian). Starten Sie jeden mit

    swage-console --store postgresql://user@server/swage?sslmode=verify-full --station &quot;Tisch 1&quot;

Die Benutzer dieses Servers entscheiden, wer was sehen und sagen darf, und sslmode verschlüsselt es unterwegs. Sonst lauscht nichts im Netz, und keine Lektion wartet je darauf.</translation>
    </message>
    <message>
        <source>Asking the server …</source>
        <translation>Der Server wird gefragt …</translation>
    </message>
    <message>
        <source>▲ The stations cannot be seen. %1

It is tried again every 2 s.</source>
        <translation>▲ Die Plätze sind nicht zu sehen. %1

Alle 2 s wird es wieder versucht.</translation>
    </message>
    <message>
        <source>No station chosen</source>
        <translation>Kein Platz gewählt</translation>
    </message>
    <message>
        <source>No picture yet</source>
        <translation>Noch kein Bild</translation>
    </message>
    <message>
        <source>A picture is asked for …</source>
        <translation>Ein Bild wird angefordert …</translation>
    </message>
    <message>
        <source>A picture of the scene as that station shows it, taken once (%1)</source>
        <translation>Ein Bild der Szene, wie der Platz sie zeigt, einmal aufgenommen (%1)</translation>
    </message>
    <message>
        <source>Pins a note to the moment two seconds ago in the attempt that runs there; the trainee does not see it (%1)</source>
        <translation>Heftet eine Notiz an den Augenblick vor zwei Sekunden im Versuch, der dort läuft; die Lernenden sehen sie nicht (%1)</translation>
    </message>
</context>
<context>
    <name>swage::console::StatusStrip</name>
    <message>
        <source>No picture yet</source>
        <translation>Noch kein Bild</translation>
    </message>
    <message>
        <source>, solver short in 1 step</source>
        <translation>, Löser in 1 Schritt ungenau</translation>
    </message>
    <message>
        <source>, solver short in %1 steps</source>
        <translation>, Löser in %1 Schritten ungenau</translation>
    </message>
    <message>
        <source>%1 of the lesson&apos;s parts stopped.</source>
        <translation>%1 Teile der Lektion haben angehalten.</translation>
    </message>
    <message>
        <source>%1 steps were late. Forces may feel rough.</source>
        <translation>%1 Schritte waren verspätet. Kräfte können sich rau anfühlen.</translation>
    </message>
    <message>
        <source>The solver fell short in %1 steps: %2.</source>
        <translation>Der Löser blieb in %1 Schritten ungenau: %2.</translation>
    </message>
    <message>
        <source>The force loop is on time.</source>
        <translation>Die Kraftschleife ist pünktlich.</translation>
    </message>
    <message>
        <source>▲ %1: no reply</source>
        <translation>▲ %1: keine Antwort</translation>
    </message>
    <message>
        <source>● %1: OK</source>
        <translation>● %1: in Ordnung</translation>
    </message>
    <message>
        <source>● Recording</source>
        <translation>● Zeichnet auf</translation>
    </message>
    <message>
        <source>○ Not recorded</source>
        <translation>○ Nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>%1  %2 steps/s, worst %L3 ms, %4 late</source>
        <translation>%1  %2 Schritte/s, längster %L3 ms, %4 verspätet</translation>
    </message>
    <message>
        <source>Time from picture to picture: half of them take no longer than the first number, 99 of 100 no longer than the second; how many pictures there were; and the time from a movement of mouse or key to the first picture that can show it, without the screen&apos;s own delay (F12 hides it)</source>
        <translation>Zeit von Bild zu Bild: die Hälfte braucht nicht länger als die erste Zahl, 99 von 100 nicht länger als die zweite; wie viele Bilder es gab; und die Zeit von einer Bewegung der Maus oder Taste bis zum ersten Bild, das sie zeigen kann, ohne die Verzögerung des Bildschirms (F12 blendet es aus)</translation>
    </message>
    <message>
        <source>%1 fps, p50 %L2 ms, p99 %L3 ms, picture %4</source>
        <translation>%1 Bilder/s, p50 %L2 ms, p99 %L3 ms, Bild %4</translation>
    </message>
    <message>
        <source>, hand to picture p50 %1 ms, p99 %2 ms</source>
        <translation>, Hand bis Bild p50 %1 ms, p99 %2 ms</translation>
    </message>
    <message>
        <source>, not everything is drawn</source>
        <translation>, nicht alles gezeichnet</translation>
    </message>
    <message>
        <source>What is drawn on %1 was left out %2 times; first for its primitive %3 (%4), member %5.</source>
        <translation>Was auf %1 gezeichnet wird, wurde %2-mal weggelassen; zuerst wegen des Elements %3 (%4), Angabe %5.</translation>
    </message>
    <message>
        <source>Of what is drawn the end was left out %1 times, for lack of room.</source>
        <translation>Vom Gezeichneten wurde %1-mal das Ende weggelassen, weil der Platz fehlte.</translation>
    </message>
    <message>
        <source>▲ %1, %L2 s behind the hand</source>
        <translation>▲ %1, %L2 s hinter der Hand</translation>
    </message>
    <message>
        <source>The picture comes so long after mouse and keys: move a little, and wait for it. Smaller windows and fewer insets are quicker.</source>
        <translation>Das Bild kommt so lange nach Maus und Tasten: wenig bewegen und auf das Bild warten. Kleinere Fenster und weniger kleine Ansichten gehen schneller.</translation>
    </message>
</context>
<context>
    <name>swage::console::StoreLink</name>
    <message>
        <source>Nothing is kept: the program was started without a store.</source>
        <translation>Nichts wird behalten: das Programm wurde ohne Speicher gestartet.</translation>
    </message>
    <message>
        <source>The attempts cannot be read: %1</source>
        <translation>Die Versuche können nicht gelesen werden: %1</translation>
    </message>
</context>
<context>
    <name>swage::console::Timeline</name>
    <message>
        <source>Timeline of the attempt</source>
        <translation>Zeitleiste des Versuchs</translation>
    </message>
    <message>
        <source>nothing is open</source>
        <translation>nichts ist geöffnet</translation>
    </message>
    <message>
        <source>%L1 s of %L2 s</source>
        <translation>%L1 s von %L2 s</translation>
    </message>
    <message>
        <source>%L1 s: %2</source>
        <translation>%L1 s: %2</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Nothing was recorded of this attempt.</source>
        <translation>Von diesem Versuch wurde nichts aufgezeichnet.</translation>
    </message>
</context>
<context>
    <name>swage::console::TracePlot</name>
    <message>
        <source>%1, last 10 seconds</source>
        <translation>%1, letzte 10 Sekunden</translation>
    </message>
    <message>
        <source>nothing yet</source>
        <translation>noch nichts</translation>
    </message>
    <message>
        <source>highest %L1 %2</source>
        <translation>höchstens %L1 %2</translation>
    </message>
    <message>
        <source>−10 s</source>
        <translation>−10 s</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
</context>
<context>
    <name>swage::console::TracesList</name>
    <message>
        <source>Which traces are shown</source>
        <translation>Welche Kurven gezeigt werden</translation>
    </message>
    <message>
        <source>%1 (never changes)</source>
        <translation>%1 (ändert sich nie)</translation>
    </message>
</context>
<context>
    <name>swage::console::TrackPlot</name>
    <message>
        <source>Entry penetration</source>
        <translation>Einstich in die Oberfläche</translation>
    </message>
    <message>
        <source>wound %1 % of the needle, mean cosine %L2</source>
        <translation>Wunde %1 % der Nadel, mittlerer Kosinus %L2</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>Cosine of the penetration angle</source>
        <translation>Kosinus des Einstichwinkels</translation>
    </message>
    <message>
        <source>mean %L1</source>
        <translation>Mittel %L1</translation>
    </message>
    <message>
        <source>%L1 s</source>
        <translation>%L1 s</translation>
    </message>
    <message>
        <source>The needle did not go in.</source>
        <translation>Die Nadel ist nicht eingedrungen.</translation>
    </message>
    <message>
        <source>Entry penetration, seen onto the surface</source>
        <translation>Einstich, auf die Oberfläche gesehen</translation>
    </message>
    <message>
        <source>wound %1 %, torn: red; 100 %: green</source>
        <translation>Wunde %1 %, gerissen: rot; 100 %: grün</translation>
    </message>
    <message>
        <source>the cross is the first puncture</source>
        <translation>das Kreuz ist der erste Einstich</translation>
    </message>
</context>
<context>
    <name>swage::console::TraineePlace</name>
    <message>
        <source>Swage, trainee: replay</source>
        <translation>Swage, Trainee: Wiedergabe</translation>
    </message>
    <message>
        <source>Swage, trainee</source>
        <translation>Swage, Trainee</translation>
    </message>
</context>
<context>
    <name>swage::console::TraineeSettings</name>
    <message>
        <source>Trainee view</source>
        <translation>Ansicht des Trainees</translation>
    </message>
    <message>
        <source>Red and cyan glasses change the colours of the cues: shapes and words then tell them</source>
        <translation>Rot-Cyan-Brillen verändern die Farben der Hinweise: dann sagen es Formen und Wörter</translation>
    </message>
    <message>
        <source>&amp;Picture</source>
        <translation>&amp;Bild</translation>
    </message>
    <message>
        <source>&amp;Half-width side by side (3D TV)</source>
        <translation>&amp;Halbe Breite nebeneinander (3D-Fernseher)</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>Left and right</source>
        <translation>Links und rechts</translation>
    </message>
    <message>
        <source>Up and down</source>
        <translation>Oben und unten</translation>
    </message>
    <message>
        <source>For a screen that is seen in a mirror over the hand</source>
        <translation>Für einen Bildschirm, der im Spiegel über der Hand gesehen wird</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>&amp;Spiegeln</translation>
    </message>
    <message>
        <source>S&amp;wap eyes</source>
        <translation>Augen &amp;tauschen</translation>
    </message>
    <message>
        <source>Stereo base of the microscope, at a working distance of 250 mm; 24 mm is usual, more exaggerates the depth</source>
        <translation>Stereobasis des Mikroskops bei 250 mm Arbeitsabstand; 24 mm sind üblich, mehr übertreibt die Tiefe</translation>
    </message>
    <message>
        <source>&amp;Eye separation</source>
        <translation>&amp;Augenabstand</translation>
    </message>
    <message>
        <source>Things at this distance lie in the plane of the screen. 250 mm is the plane in focus; with less, everything recedes behind the screen</source>
        <translation>Was so weit entfernt ist, liegt in der Ebene des Bildschirms. Bei 250 mm ist es die Schärfeebene; bei weniger tritt alles hinter den Bildschirm</translation>
    </message>
    <message>
        <source>&amp;Convergence</source>
        <translation>&amp;Konvergenz</translation>
    </message>
    <message>
        <source>Sc&amp;reen</source>
        <translation>Bil&amp;dschirm</translation>
    </message>
    <message>
        <source>&amp;Full screen (F11)</source>
        <translation>&amp;Vollbild (F11)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Close the trainee&apos;s view</source>
        <translation>Das Fenster des Trainees schließen</translation>
    </message>
    <message>
        <source>Show the trainee&apos;s view</source>
        <translation>Das Fenster des Trainees zeigen</translation>
    </message>
    <message>
        <source>Look of a &amp;microscope</source>
        <translation>Ansicht wie durch ein &amp;Mikroskop</translation>
    </message>
    <message>
        <source>A round field, its light fading to the rim</source>
        <translation>Ein rundes Feld, dessen Licht zum Rand hin abnimmt</translation>
    </message>
    <message>
        <source>As makers say it: 1 is the bare eye at 250 mm. In the view Ctrl+Page up and down, a pedal that sends them, or the wheel. Where the station was measured it is true</source>
        <translation>Wie Hersteller es angeben: 1 ist das bloße Auge bei 250 mm. In der Ansicht Strg+Bild auf und ab, ein Pedal, das sie sendet, oder das Rad. Wo der Platz ausgemessen wurde, stimmt es</translation>
    </message>
    <message>
        <source> ×</source>
        <translation> ×</translation>
    </message>
    <message>
        <source>Ma&amp;gnification</source>
        <translation>&amp;Vergrößerung</translation>
    </message>
    <message>
        <source>Glasses that shut in turn (frame-sequential) need a driver with quad buffers, and this one has none.</source>
        <translation>Brillen, die abwechselnd schließen (Shutter), brauchen einen Treiber mit Quad-Buffer, und dieser hat keinen.</translation>
    </message>
    <message>
        <source>&amp;Depth of field</source>
        <translation>Ti&amp;efenschärfe</translation>
    </message>
    <message>
        <source>What lies before and behind the plane in focus is unsharp; in the view Ctrl+Shift+Page up and down move that plane. Without a graphics card pictures come less often</source>
        <translation>Was vor und hinter der scharfen Ebene liegt, ist unscharf; in der Ansicht verschieben Strg+Umschalt+Bild auf und ab diese Ebene. Ohne Grafikkarte kommen Bilder seltener</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Every change is kept at once (Esc)</source>
        <translation>Jede Änderung gilt sofort (Esc)</translation>
    </message>
</context>
<context>
    <name>swage::console::TraineeWindow</name>
    <message>
        <source>Swage, trainee</source>
        <translation>Swage, Trainee</translation>
    </message>
    <message>
        <source>The scene for the trainee</source>
        <translation>Die Szene für den Trainee</translation>
    </message>
</context>
<context>
    <name>swage::console::VariantDialog</name>
    <message>
        <source>Edit lesson</source>
        <translation>Lektion bearbeiten</translation>
    </message>
    <message>
        <source>New lesson</source>
        <translation>Neue Lektion</translation>
    </message>
    <message>
        <source>Lesson of your own</source>
        <translation>Eigene Lektion</translation>
    </message>
    <message>
        <source>Based on %1</source>
        <translation>Nach %1</translation>
    </message>
    <message>
        <source>%1, adapted</source>
        <translation>%1, angepasst</translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation>&amp;Titel</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>A&amp;ufgabe</translation>
    </message>
    <message>
        <source>&amp;Learning goal</source>
        <translation>Lern&amp;ziel</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Find: needle, stiffness, force …</source>
        <translation>Suchen: Nadel, Steifigkeit, Kraft …</translation>
    </message>
    <message>
        <source>Find a value</source>
        <translation>Wert suchen</translation>
    </message>
    <message>
        <source>No value is called &quot;%1&quot;.</source>
        <translation>Kein Wert heißt „%1“.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>A lesson has a title.</source>
        <translation>Eine Lektion hat einen Titel.</translation>
    </message>
    <message>
        <source>One value is changed.</source>
        <translation>Ein Wert ist geändert.</translation>
    </message>
    <message>
        <source>%1 values are changed.</source>
        <translation>%1 Werte sind geändert.</translation>
    </message>
    <message>
        <source>The words are changed.</source>
        <translation>Die Texte sind geändert.</translation>
    </message>
    <message>
        <source>Those of the last attempt are kept.</source>
        <translation>Die des letzten Versuchs bleiben.</translation>
    </message>
    <message>
        <source>Your unfinished changes are here again; undo takes them back.</source>
        <translation>Die nicht beendeten Änderungen sind wieder da; Rückgängig nimmt sie zurück.</translation>
    </message>
    <message>
        <source>The scene as it would begin</source>
        <translation>Die Szene, wie sie beginnen würde</translation>
    </message>
    <message>
        <source>Save and try it</source>
        <translation>Speichern und ausprobieren</translation>
    </message>
    <message>
        <source>The lesson cannot be built with these values.</source>
        <translation>Die Lektion lässt sich mit diesen Werten nicht bauen.</translation>
    </message>
    <message>
        <source>Parts are changed.</source>
        <translation>Teile sind geändert.</translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>Change a value or a part: a copy under another title would be the same lesson.</source>
        <translation>Ändern Sie einen Wert oder ein Teil: Eine Kopie mit anderem Titel wäre dieselbe Lektion.</translation>
    </message>
    <message>
        <source>Nothing is changed yet.</source>
        <translation>Noch ist nichts geändert.</translation>
    </message>
    <message>
        <source>So are parts.</source>
        <translation>Ebenso Teile.</translation>
    </message>
    <message>
        <source>Leave without saving? What you changed here is not kept.</source>
        <translation>Ohne Speichern verlassen? Was Sie hier geändert haben, bleibt nicht.</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Go on editing</source>
        <translation>Weiter bearbeiten</translation>
    </message>
    <message>
        <source>Unchanged</source>
        <translation>Unverändert</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Kreisen</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>Nah</translation>
    </message>
    <message>
        <source>From where the trainee looks first; any view can be chosen later</source>
        <translation>Von wo der Trainee zuerst schaut; später ist jede Ansicht wählbar</translation>
    </message>
    <message>
        <source>&amp;View at the start</source>
        <translation>&amp;Ansicht zu Beginn</translation>
    </message>
    <message>
        <source>The view at the start is changed.</source>
        <translation>Die Ansicht zu Beginn ist geändert.</translation>
    </message>
</context>
<context>
    <name>swage::console::ViewBar</name>
    <message>
        <source>Orbit</source>
        <translation>Kreisen</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>Nah</translation>
    </message>
    <message>
        <source>Cues</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Show cues in the picture</source>
        <translation>Hinweise im Bild zeigen</translation>
    </message>
    <message>
        <source>Insets</source>
        <translation>Lupen</translation>
    </message>
    <message>
        <source>Small views: while the mouse is the instrument one at right angles, near the jaws; the wound magnified while there is one</source>
        <translation>Kleine Ansichten: solange die Maus das Instrument ist, eine im rechten Winkel nahe den Backen; die Wunde vergrößert, solange es eine gibt</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Kräfte</translation>
    </message>
    <message>
        <source>Show contact forces in the picture</source>
        <translation>Kontaktkräfte im Bild zeigen</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Genauer</translation>
    </message>
    <message>
        <source>For the instructor: list also what the machine did, and colour a needle that bends by its stress</source>
        <translation>Für Ausbilder: auch nennen, was die Maschine tat, und eine Nadel, die sich biegt, nach ihrer Spannung färben</translation>
    </message>
    <message>
        <source>Instructor</source>
        <translation>Ausbilder</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Readings, cues and events in a window of their own (F10); in a test on a screen that the trainee does not see</source>
        <translation>Anzeigen, Hinweise und Ereignisse in einem eigenen Fenster (F10); im Test auf einem Bildschirm, den der Trainee nicht sieht</translation>
    </message>
    <message>
        <source>%1 view; F11 goes on from %2 to %3</source>
        <translation>Ansicht %1; F11 geht von %2 weiter zu %3</translation>
    </message>
</context>
<context>
    <name>swage::console::WindowKeys</name>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>Zurücklegen</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Markierung</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Führung</translation>
    </message>
    <message>
        <source>Instructor</source>
        <translation>Ausbilder</translation>
    </message>
    <message>
        <source>Message read, lesson taken</source>
        <translation>Nachricht gelesen, Lektion genommen</translation>
    </message>
    <message>
        <source>Lesson not now</source>
        <translation>Lektion nicht jetzt</translation>
    </message>
</context>
<context>
    <name>swage::console::WindowPages</name>
    <message>
        <source>Run</source>
        <translation>Üben</translation>
    </message>
    <message>
        <source>What is happening now?</source>
        <translation>Was geschieht jetzt?</translation>
    </message>
    <message>
        <source>The program closed unexpectedly. 1 attempt was kept up to that moment.</source>
        <translation>Das Programm wurde unerwartet beendet. 1 Versuch wurde bis zu diesem Augenblick behalten.</translation>
    </message>
    <message>
        <source>The program closed unexpectedly. %1 attempts were kept up to that moment.</source>
        <translation>Das Programm wurde unerwartet beendet. %1 Versuche wurden bis zu diesem Augenblick behalten.</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>What can be practised, and what does it ask for?</source>
        <translation>Was lässt sich üben, und was fordert es?</translation>
    </message>
    <message>
        <source>Courses</source>
        <translation>Kurse</translation>
    </message>
    <message>
        <source>In what order, and when is it passed?</source>
        <translation>In welcher Reihenfolge, und wann ist es bestanden?</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Who is where, and who needs help?</source>
        <translation>Wer steht wo, und wer braucht Hilfe?</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>What happened in that attempt?</source>
        <translation>Was geschah in diesem Versuch?</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Einrichtung</translation>
    </message>
    <message>
        <source>Does the equipment work?</source>
        <translation>Funktioniert die Ausrüstung?</translation>
    </message>
    <message>
        <source>Stations</source>
        <translation>Plätze</translation>
    </message>
    <message>
        <source>Who does what at every station, now?</source>
        <translation>Wer tut gerade was an welchem Platz?</translation>
    </message>
</context>
<context>
    <name>swage::console::WorstTable</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Worst moments</source>
        <translation>Schlechteste Momente</translation>
    </message>
    <message>
        <source>A click goes there, Enter or a double click plays it again and again; W: the next</source>
        <translation>Ein Klick geht dorthin, Eingabe oder ein Doppelklick spielt es immer wieder; W: der nächste</translation>
    </message>
    <message>
        <source>%L1 s</source>
        <translation>%L1 s</translation>
    </message>
</context>
<context>
    <name>themes</name>
    <message>
        <source>Position wrong, without tips</source>
        <translation>Ort falsch, ohne Spitzen</translation>
    </message>
    <message>
        <source>Position wrong, with tips</source>
        <translation>Ort falsch, mit Spitzen</translation>
    </message>
    <message>
        <source>Position right, without tips</source>
        <translation>Ort gut, ohne Spitzen</translation>
    </message>
    <message>
        <source>Position right, tilted</source>
        <translation>Ort gut, schräg</translation>
    </message>
    <message>
        <source>Position right, with tips</source>
        <translation>Ort gut, mit Spitzen</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Gehalten</translation>
    </message>
    <message>
        <source>Too much force</source>
        <translation>Zu viel Kraft</translation>
    </message>
    <message>
        <source>Grasp here</source>
        <translation>Hier greifen</translation>
    </message>
    <message>
        <source>Move here</source>
        <translation>Hierher bewegen</translation>
    </message>
    <message>
        <source>On the mark</source>
        <translation>Auf der Marke</translation>
    </message>
    <message>
        <source>Off target</source>
        <translation>Ziel verlassen</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Touching</source>
        <translation>Berührt</translation>
    </message>
    <message>
        <source>Perpendicular to the tissue</source>
        <translation>Senkrecht zum Gewebe</translation>
    </message>
    <message>
        <source>Look here</source>
        <translation>Hierher sehen</translation>
    </message>
    <message>
        <source>Leans this way</source>
        <translation>Neigt sich hierhin</translation>
    </message>
    <message>
        <source>Or this way</source>
        <translation>Oder hierhin</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Richtig</translation>
    </message>
    <message>
        <source>To the other side</source>
        <translation>Zur anderen Seite</translation>
    </message>
    <message>
        <source>Square knot</source>
        <translation>Kreuzknoten</translation>
    </message>
    <message>
        <source>Granny</source>
        <translation>Altweiberknoten</translation>
    </message>
    <message>
        <source>Sliding knot</source>
        <translation>Gleitender Knoten</translation>
    </message>
    <message>
        <source>Loose first throw</source>
        <translation>Lockerer erster Wurf</translation>
    </message>
    <message>
        <source>Pulled here</source>
        <translation>Hier wird gezogen</translation>
    </message>
    <message>
        <source>It is another knot</source>
        <translation>Es ist ein anderer Knoten</translation>
    </message>
    <message>
        <source>It holds</source>
        <translation>Er hält</translation>
    </message>
    <message>
        <source>It gives way</source>
        <translation>Er gibt nach</translation>
    </message>
    <message>
        <source>Puncture here</source>
        <translation>Hier einstechen</translation>
    </message>
    <message>
        <source>Come out here</source>
        <translation>Hier ausstechen</translation>
    </message>
    <message>
        <source>The tissue tears</source>
        <translation>Das Gewebe reißt</translation>
    </message>
    <message>
        <source>Deflected: change the angle</source>
        <translation>Abgelenkt: Winkel ändern</translation>
    </message>
    <message>
        <source>Needle left in the tissue</source>
        <translation>Nadel im Gewebe gelassen</translation>
    </message>
    <message>
        <source>Held at the swage: damages the suture</source>
        <translation>Armierung gefasst: schadet</translation>
    </message>
    <message>
        <source>Thread length right</source>
        <translation>Faden richtig lang</translation>
    </message>
    <message>
        <source>The needle is bent</source>
        <translation>Die Nadel ist verbogen</translation>
    </message>
    <message>
        <source>Dropped</source>
        <translation>Gefallen</translation>
    </message>
    <message>
        <source>Original colours</source>
        <translation>Originalfarben</translation>
    </message>
    <message>
        <source>Colour-blind safe</source>
        <translation>Farbenblindensicher</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>low, one knock</source>
        <translation>tief, einmal klopfen</translation>
    </message>
    <message>
        <source>low, two knocks</source>
        <translation>tief, zweimal klopfen</translation>
    </message>
    <message>
        <source>high, one knock</source>
        <translation>hoch, einmal klopfen</translation>
    </message>
    <message>
        <source>high, two knocks</source>
        <translation>hoch, zweimal klopfen</translation>
    </message>
    <message>
        <source>soft rattle</source>
        <translation>leises Rasseln</translation>
    </message>
    <message>
        <source>chime</source>
        <translation>Glockenspiel</translation>
    </message>
    <message>
        <source>falling</source>
        <translation>fallend</translation>
    </message>
    <message>
        <source>tear</source>
        <translation>Reißen</translation>
    </message>
    <message>
        <source>thud</source>
        <translation>dumpf</translation>
    </message>
    <message>
        <source>click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>Leave this length of thread</source>
        <translation>So viel Faden lassen</translation>
    </message>
    <message>
        <source>Pulls on the tissue</source>
        <translation>Zieht am Gewebe</translation>
    </message>
    <message>
        <source>Turns are on: keep them drawn</source>
        <translation>Windungen straff halten</translation>
    </message>
    <message>
        <source>Too many turns</source>
        <translation>Zu viele Windungen</translation>
    </message>
    <message>
        <source>Tied, and flat</source>
        <translation>Geknüpft, liegt flach</translation>
    </message>
    <message>
        <source>A throw is loose: draw it down</source>
        <translation>Ein Wurf ist lose: festziehen</translation>
    </message>
    <message>
        <source>Not this throw, or it slides</source>
        <translation>Falscher Wurf, er gleitet</translation>
    </message>
    <message>
        <source>Edges together</source>
        <translation>Ränder beisammen</translation>
    </message>
    <message>
        <source>Off-angle: rotate along the curve</source>
        <translation>Winkel falsch: entlang der Krümmung drehen</translation>
    </message>
</context>
<context>
    <name>words</name>
    <message>
        <source>at %1 % of real speed</source>
        <translation>mit %1 % der wirklichen Geschwindigkeit</translation>
    </message>
    <message>
        <source>no forces for %1 s</source>
        <translation>%1 s ohne Kräfte</translation>
    </message>
    <message>
        <source>%1 steps not recorded</source>
        <translation>%1 Schritte nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>Nicht bestanden</translation>
    </message>
    <message>
        <source>Void</source>
        <translation>Ungültig</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>Demo</source>
        <translation>Demo</translation>
    </message>
    <message>
        <source>d MMM yyyy HH:mm</source>
        <translation>d. MMM yyyy HH:mm</translation>
    </message>
    <message>
        <source>d MMM yyyy</source>
        <translation>d. MMM yyyy</translation>
    </message>
    <message>
        <source>%1, on the way to %2</source>
        <translation>%1, unterwegs nach %2</translation>
    </message>
</context>
</TS>
